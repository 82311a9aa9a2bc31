#include "parser/expression/string_expression.h"

#include "parser/expression/evaluator.h"
#include "parser/expression/utf8.h"
#include "parser/expression/words.h"

#include <charconv>

namespace firstlight::parser {

namespace {

std::string parse_string_function(Evaluator& in, const Token& word) {
  in.expect(Punctuation::left_paren, "after", word.text);
  std::string result = std::get<Word::StringReader>(word_of(word.keyword).value)(in, word);
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

}  // namespace firstlight::parser
