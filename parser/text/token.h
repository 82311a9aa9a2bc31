#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace firstlight::parser {

/// Reserved words. A word that C++ reserves too has a trailing underscore: `Keyword::union_`.
enum class Keyword : std::uint16_t {
  none,
#define KEYWORD(name, spelling) name,
#include "parser/keywords.def"
#undef KEYWORD
};

/// How many there are, Keyword::none among them.
constexpr std::size_t kKeywordCount = 1
#define KEYWORD(name, spelling) +1
#include "parser/keywords.def"
#undef KEYWORD
    ;

/// Marks. `less` and `greater` are also the brackets of a vector; `dash` is both minus signs.
enum class Punctuation : std::uint8_t {
  none,
  left_brace,
  right_brace,
  left_paren,
  right_paren,
  left_bracket,
  right_bracket,
  less,
  greater,
  less_equal,
  greater_equal,
  equal,
  not_equal,
  plus,
  dash,
  star,
  slash,
  bar,
  ampersand,
  exclamation,
  question,
  colon,
  semicolon,
  comma,
  period,
  hash,
  at,
  backquote,
  backslash,
  dollar,
  hat,
  percent,
  quote,
  tilde,
};

/// Where a token begins. `line` and `column` count from 1, in bytes; `file` numbers the files as they were first read.
struct Location {
  std::uint32_t file = 0;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::uint32_t length = 0;  ///< bytes, on this line
};

enum class TokenKind : std::uint8_t { end, keyword, identifier, number, string, punctuation };

/// The smallest piece of the scene text.
/// Memory   `text` is a view that lives as long as the Interpreter: spelling of a word or number, contents of a string
///          with its escapes as they are written (Reader::string() replaces them).
struct Token {
  TokenKind kind = TokenKind::end;
  Punctuation punctuation = Punctuation::none;
  Keyword keyword = Keyword::none;
  std::uint32_t symbol = 0;  ///< of an identifier: its number, the same for the same spelling
  double number = 0.0;
  std::string_view text;
  Location location;

  bool is(Keyword word) const { return kind == TokenKind::keyword && keyword == word; }
  bool is(Punctuation mark) const { return kind == TokenKind::punctuation && punctuation == mark; }
  bool is_end() const { return kind == TokenKind::end; }
};

/// `Keyword::none` when `text` is not reserved.
Keyword find_keyword(std::string_view text);
std::string_view spelling(Keyword word);
/// Whether the directive of that word begins a block, which `#end` closes.
bool opens_block(Keyword word);
std::string_view spelling(Punctuation mark);

/// For messages: "'sphere'", "number 3.5", "string \"abc\"", "end of file".
std::string describe(const Token& token);

}  // namespace firstlight::parser
