#pragma once

#include "parser/text/source.h"
#include "parser/text/token.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>

namespace firstlight::parser {

/// Numbers for identifiers: equal spellings, equal numbers, counted from 0.
class Symbols {
 public:
  std::uint32_t intern(std::string_view name);
  std::string_view name(std::uint32_t symbol) const { return names_[symbol]; }
  std::size_t size() const { return names_.size(); }

 private:
  std::deque<std::string> names_;  // a deque, for the table's keys point into it
  std::unordered_map<std::string_view, std::uint32_t> table_;
};

/// Cuts a text into tokens, one at each call. Throws SyntaxError for what cannot be text of a scene.
class Lexer {
 public:
  /// Where a token begins.
  struct Place {
    std::uint32_t offset = 0;  ///< bytes from the beginning of the text
    std::uint32_t line = 1;
  };

  Lexer(const SourceFile& source, Symbols& symbols);
  /// Goes on at a place in a text that has been cut before.
  Lexer(const SourceFile& source, Symbols& symbols, Place begin);
  ~Lexer();
  Token next();  ///< TokenKind::end behind the last
  /// The same without the number of a number.
  Token next_in_outline();
  /// The one where the token begins that was given last.
  Place place() const;

 private:
  class Pass;
  std::unique_ptr<Pass> pass_;
};

}  // namespace firstlight::parser
