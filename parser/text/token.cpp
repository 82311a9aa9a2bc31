#include "parser/text/token.h"

#include <array>
#include <unordered_map>

namespace firstlight::parser {

namespace {

constexpr auto kKeywordSpellings = std::to_array<std::string_view>({
    "",
#define KEYWORD(name, spelling) spelling,
#include "parser/keywords.def"
#undef KEYWORD
});

// In the order of Punctuation.
constexpr auto kPunctuationSpellings = std::to_array<std::string_view>(
    {"",  "{", "}", "(", ")", "[", "]", "<", ">", "<=", ">=", "=",  "!=", "+", "-", "*", "/",
     "|", "&", "!", "?", ":", ";", ",", ".", "#", "@",  "`",  "\\", "$",  "^", "%", "'", "~"});

std::unordered_map<std::string_view, Keyword> make_keyword_table() {
  std::unordered_map<std::string_view, Keyword> table;
#define KEYWORD(name, spelling) table.emplace(spelling, Keyword::name);
#define KEYWORD_SYNONYM(name, spelling) table.emplace(spelling, Keyword::name);
#include "parser/keywords.def"
#undef KEYWORD
  return table;
}

constexpr std::size_t kLongestQuotedString = 40;  // bytes of a string that a message repeats

}  // namespace

Keyword find_keyword(std::string_view text) {
  static const auto table = make_keyword_table();
  const auto found = table.find(text);
  return found == table.end() ? Keyword::none : found->second;
}

std::string_view spelling(Keyword word) { return kKeywordSpellings[static_cast<std::size_t>(word)]; }

std::string_view spelling(Punctuation mark) { return kPunctuationSpellings[static_cast<std::size_t>(mark)]; }

std::string describe(const Token& token) {
  switch (token.kind) {
    case TokenKind::end:
      return "end of file";
    case TokenKind::number:
      return "number " + std::string(token.text);
    case TokenKind::string: {
      const bool long_text = token.text.size() > kLongestQuotedString;
      return "string \"" + std::string(token.text.substr(0, kLongestQuotedString)) + (long_text ? "...\"" : "\"");
    }
    case TokenKind::keyword:
    case TokenKind::identifier:
    case TokenKind::punctuation:
      break;
  }
  return "'" + std::string(token.text) + "'";
}

bool opens_block(Keyword word) {
  switch (word) {
    case Keyword::if_:
    case Keyword::ifdef:
    case Keyword::ifndef:
    case Keyword::switch_:
    case Keyword::while_:
    case Keyword::for_:
    case Keyword::macro:
      return true;
    default:
      return false;
  }
}

}  // namespace firstlight::parser
