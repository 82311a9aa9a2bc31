#include "parser/expression/utf8.h"

#include <algorithm>
#include <charconv>

namespace firstlight::parser {

namespace {

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

}  // namespace

std::string encode(unsigned code) {
  if (code < 0x80) return std::string(1, static_cast<char>(code));
  const auto part = [code](unsigned shift) { return static_cast<char>(0x80 | ((code >> shift) & 0x3f)); };
  if (code < 0x800) return {static_cast<char>(0xc0 | (code >> 6)), part(0)};
  return {static_cast<char>(0xe0 | (code >> 12)), part(6), part(0)};
}

std::size_t offset_of(const std::string& text, std::size_t index) {
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    if (continues_character(text[at])) continue;
    if (index-- == 0) break;
  }
  return at;
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
