#include "parser/expression/string_expression.h"

#include "parser/expression/evaluator.h"
#include "parser/expression/expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <ctime>
#include <vector>

namespace firstlight::parser {

namespace {

constexpr int kWidestNumber = 300;    // of str() and vstr(): beyond POV-Ray's own buffer
constexpr int kLargestCode = 0xffff;  // POV-Ray's characters have 16 bits

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

// Byte offset of character `index`; the text's size beyond its end.
std::size_t offset_of(const std::string& text, std::size_t index) {
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    if (continues_character(text[at])) continue;
    if (index-- == 0) break;
  }
  return at;
}

std::string encode(unsigned code) {
  if (code < 0x80) return std::string(1, static_cast<char>(code));
  const auto part = [code](unsigned shift) { return static_cast<char>(0x80 | ((code >> shift) & 0x3f)); };
  if (code < 0x800) return {static_cast<char>(0xc0 | (code >> 6)), part(0)};
  return {static_cast<char>(0xe0 | (code >> 12)), part(6), part(0)};
}

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

std::string parse_str(Evaluator& in) {
  const double value = parse_float(in);
  comma(in);
  const int width = whole(parse_float(in));
  comma(in);
  return print(value, width, whole(parse_float(in)));
}

std::string parse_vstr(Evaluator& in) {
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
      in.fail(word.location,
              "the string is too long (limit " + std::to_string(Evaluator::kLongestString) + " bytes)");
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

// Days since 2000 as a date, in universal time.
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

std::string in_case(std::string text, bool upper) {
  for (char& c : text) {
    if (upper && c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    if (!upper && c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

std::string parse_string_function(Evaluator& in, const Token& word) {
  in.expect(Punctuation::left_paren, "after", word.text);
  std::string result;
  switch (word.keyword) {
    case Keyword::chr:
      result = parse_chr(in, word);
      break;
    case Keyword::concat:
      result = parse_concat(in, word);
      break;
    case Keyword::datetime:
      result = parse_datetime(in, word);
      break;
    case Keyword::str:
      result = parse_str(in);
      break;
    case Keyword::vstr:
      result = parse_vstr(in);
      break;
    case Keyword::substr:
      result = parse_substr(in, word);
      break;
    default:
      result = in_case(parse_string(in), word.is(Keyword::strupr));
      break;
  }
  in.expect(Punctuation::right_paren, "to close", word.text);
  return result;
}

// The character that an escape stands for; `at` is behind the backslash and moves to its last letter.
std::string unescape_one(Evaluator& in, const Token& literal, std::size_t& at) {
  const std::string_view raw = literal.text;
  constexpr std::string_view kLetters = "abfnrtv\\'\"";
  constexpr std::string_view kMeanings = "\a\b\f\n\r\t\v\\'\"";
  const std::size_t known = kLetters.find(raw[at]);
  if (known != std::string_view::npos) return std::string(1, kMeanings[known]);
  if (raw[at] != 'u') {
    in.fail(literal.location, std::string("'\\") + raw[at] + "' is no escape sequence of strings");
  }
  unsigned code = 0;
  const char* digits = raw.data() + at + 1;
  if (at + 4 >= raw.size() || std::from_chars(digits, digits + 4, code, 16).ptr != digits + 4) {
    in.fail(literal.location, "expected four hexadecimal digits after '\\u' in this string");
  }
  at += 4;
  return encode(code);
}

}  // namespace

std::string unescape(Evaluator& in, const Token& literal) {
  const std::string_view raw = literal.text;
  const bool ascii = in.language().charset() == render::Charset::ascii;
  const bool latin = ascii && in.language_version() < 350;
  bool replaced = false;
  std::string result;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const auto byte = static_cast<unsigned char>(raw[i]);
    if (raw[i] == '\\' && i + 1 < raw.size()) {
      result += unescape_one(in, literal, ++i);
    } else if (byte < 0x80 || !ascii) {
      result += raw[i];
    } else {
      result += latin ? encode(byte) : " ";
      replaced = replaced || !latin;
    }
  }
  if (replaced) {
    in.warn(
        literal.location,
        "characters of this string that are not ASCII are taken as blanks; 'charset utf8' in 'global_settings' keeps "
        "them");
  }
  return result;
}

bool at_string(Evaluator& in) {
  const Token& token = in.peek();
  if (token.kind == TokenKind::string) return true;
  if (token.kind == TokenKind::keyword) return word_kind(token.keyword) == WordKind::string;
  const Value* value = token.kind == TokenKind::identifier ? in.peek_value() : nullptr;
  return value != nullptr && std::holds_alternative<std::string>(*value);
}

std::string parse_string(Evaluator& in) {
  const Evaluator::Release release(in);
  const Evaluator::Nesting nesting(in);
  if (!at_string(in)) in.fail(in.peek().location, "expected a string, found " + in.describe_next());
  if (in.peek().kind == TokenKind::identifier) {
    std::string result = std::get<std::string>(*in.peek_value());
    in.take();
    return result;
  }
  const Token& token = in.take();
  return token.kind == TokenKind::string ? unescape(in, token) : parse_string_function(in, token);
}

std::string parse_path(Evaluator& in) {
  return in.peek().kind == TokenKind::string ? std::string(in.take().text) : parse_string(in);
}

std::size_t length_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

unsigned first_code_of(const std::string& text) {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  if (byte(0) < 0x80) return byte(0);
  if (byte(0) < 0xe0) return ((byte(0) & 0x1fu) << 6) | (byte(1) & 0x3fu);
  return ((byte(0) & 0x0fu) << 12) | ((byte(1) & 0x3fu) << 6) | (byte(2) & 0x3fu);
}

int compare_codes(const std::string& left, const std::string& right) {
  std::size_t at = static_cast<std::size_t>(std::mismatch(left.begin(), left.end(), right.begin(), right.end()).first -
                                            left.begin());
  while (
      at > 0 && at < std::max(left.size(), right.size()) &&
      ((at < left.size() && continues_character(left[at])) || (at < right.size() && continues_character(right[at])))) {
    --at;
  }
  return static_cast<int>(first_code_of(left.substr(std::min(at, left.size())))) -
         static_cast<int>(first_code_of(right.substr(std::min(at, right.size()))));
}

double value_of(const std::string& text) {
  std::size_t start = text.find_first_not_of(" \t\n\r\v\f");
  if (start == std::string::npos) return 0.0;
  const bool negative = text[start] == '-';
  if (negative || text[start] == '+') ++start;
  const bool hexadecimal = text.size() > start + 2 && text[start] == '0' && (text[start + 1] | 0x20) == 'x';
  if (hexadecimal) start += 2;
  if (start < text.size() && (text[start] == '-' || text[start] == '+')) return 0.0;
  double result = 0.0;
  std::from_chars(text.data() + start, text.data() + text.size(), result,
                  hexadecimal ? std::chars_format::hex : std::chars_format::general);
  return negative ? -result : result;
}

}  // namespace firstlight::parser
