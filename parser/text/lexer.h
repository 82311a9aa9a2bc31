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
#include <vector>

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

constexpr std::uint32_t kNoLink = 0;

/// A file cut into tokens; the last one is always TokenKind::end.
///
/// Links    The `#` of a block directive (#if, #while, #macro ...) holds in `symbol` the index of the `#` of what
///          follows it in the same block: #else, #elseif, #case, #range or #end; kNoLink when the file ends first.
///          Skipping text is following links, not reading it.
struct TokenFile {
  const SourceFile* source = nullptr;
  std::vector<Token> tokens;
  std::size_t first = 0;  ///< how many tokens are in the files that were cut before it
};

/// The index of the `#` of the `#end` that closes the block which the `#` at `hash` begins or is a branch of; kNoLink
/// when the file ends before it.
std::uint32_t end_of_block(const TokenFile& file, std::uint32_t hash);

/// Cuts a text into tokens, one at each call. Throws SyntaxError for what cannot be text of a scene.
class Lexer {
 public:
  Lexer(const SourceFile& source, Symbols& symbols);
  ~Lexer();
  Token next();  ///< TokenKind::end behind the last

 private:
  class Pass;
  std::unique_ptr<Pass> pass_;
};

/// Cuts `source` into tokens. Throws SyntaxError for what cannot be text of a scene, and for a loop or macro without
/// #end.
TokenFile tokenize(const SourceFile& source, Symbols& symbols);

}  // namespace firstlight::parser
