#include "parser/expression/string_functions.h"

#include "parser/expression/evaluator.h"
#include "parser/expression/expression.h"
#include "parser/expression/string_expression.h"
#include "parser/expression/utf8.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace firstlight::parser {

namespace {

constexpr int kWidestNumber = 300;    // of str() and vstr(): beyond POV-Ray's own buffer
constexpr int kLargestCode = 0xffff;  // POV-Ray's characters have 16 bits

int whole(double value) { return static_cast<int>(std::clamp(value, -1e6, 1e6)); }

void comma(Evaluator& in) {
  if (in.peek().is(Punctuation::comma)) in.take();
}

// `%f` with a width (below 0: filled up with zeros) and decimals (below 0: six).
std::string print(double value, int width, int decimals) {
  width = std::clamp(width, -kWidestNumber, kWidestNumber);
  decimals = std::min(decimals, kWidestNumber);
  std::array<char, 2 * kWidestNumber + 400> buffer{};
  const bool zeros = width < 0;
  if (decimals < 0) {
    std::snprintf(buffer.data(), buffer.size(), zeros ? "%0*f" : "%*f", std::abs(width), value);
  } else {
    std::snprintf(buffer.data(), buffer.size(), zeros ? "%0*.*f" : "%*.*f", std::abs(width), decimals, value);
  }
  return buffer.data();
}

}  // namespace

std::string parse_str(Evaluator& in, const Token&) {
  const double value = parse_float(in);
  comma(in);
  const int width = whole(parse_float(in));
  comma(in);
  return print(value, width, whole(parse_float(in)));
}

std::string parse_vstr(Evaluator& in, const Token&) {
  const int count = std::clamp(whole(parse_float(in)), 2, 5);
  comma(in);
  const Numbers numbers = parse_sum(in, 1);
  comma(in);
  const std::string separator = parse_string(in);
  comma(in);
  const int width = whole(parse_float(in));
  comma(in);
  const int decimals = whole(parse_float(in));
  std::string result;
  for (int i = 0; i < count; ++i) {
    if (i > 0) result += separator;
    result += print(i < numbers.size ? numbers.values[static_cast<std::size_t>(i)] : 0.0, width, decimals);
  }
  return result;
}

std::string parse_concat(Evaluator& in, const Token& word) {
  std::string result = parse_string(in);
  while (!in.peek().is(Punctuation::right_paren)) {
    comma(in);
    result += parse_string(in);
    if (result.size() > Evaluator::kLongestString) {
      in.fail(word.location, "the string is too long (limit " + std::to_string(Evaluator::kLongestString) + " bytes)");
    }
  }
  return result;
}

std::string parse_substr(Evaluator& in, const Token& word) {
  const std::string text = parse_string(in);
  comma(in);
  const int first = whole(parse_float(in));
  comma(in);
  const int count = whole(parse_float(in));
  const int length = static_cast<int>(length_of(text));
  if (first == 0) return {};  // as POV-Ray has it, whatever the length
  if (first < 1 || count < 0 || first + count - 1 > length) {
    in.fail(word.location, "'substr' of " + std::to_string(count) + " characters from character " +
                               std::to_string(first) + " on does not fit a string of " + std::to_string(length));
  }
  const std::size_t begin = offset_of(text, static_cast<std::size_t>(first - 1));
  return text.substr(begin, offset_of(text, static_cast<std::size_t>(first - 1 + count)) - begin);
}

std::string parse_chr(Evaluator& in, const Token& word) {
  const double code = parse_float(in);
  if (!(code > -1.0 && code < kLargestCode + 1)) {
    in.fail(word.location,
            "'chr' needs a number from 0 to " + std::to_string(kLargestCode) + ", found " + number_text(code));
  }
  return encode(static_cast<unsigned>(code));
}

std::string parse_datetime(Evaluator& in, const Token& word) {
  constexpr double kDaysTo2000 = 365 * 30 + 7;  // from 1970
  const double seconds = std::floor((parse_float(in) + kDaysTo2000) * 86400.0 + 0.5);
  comma(in);
  std::string format = "%Y-%m-%d %H:%M:%SZ";
  if (!in.peek().is(Punctuation::right_paren)) format = parse_string(in);
  const std::time_t time = static_cast<std::time_t>(std::clamp(seconds, -1e11, 1e11));
  std::tm parts{};
  std::array<char, 201> buffer{};
  if (gmtime_r(&time, &parts) == nullptr || std::strftime(buffer.data(), buffer.size(), format.c_str(), &parts) == 0) {
    in.fail(word.location, "the format of 'datetime' gives no text, or too much");
  }
  return buffer.data();
}

std::string parse_in_case(Evaluator& in, const Token& word) {
  const bool upper = word.is(Keyword::strupr);
  std::string text = parse_string(in);
  for (char& c : text) {
    if (upper && c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    if (!upper && c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

}  // namespace firstlight::parser
