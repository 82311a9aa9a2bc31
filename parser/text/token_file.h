#pragma once

#include "parser/text/lexer.h"
#include "parser/text/source.h"
#include "parser/text/token.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::parser {

/// The index of a `#` that is not there.
constexpr std::uint32_t kNoLink = 0;

/// A directive that begins, parts or ends a block: #if, #else, #macro, #end ...
struct BlockDirective {
  std::uint32_t hash = 0;      ///< index of its `#` among the tokens
  std::uint32_t follower = 0;  ///< place in the list of the next directive of the same block; 0: the file ends first
  Keyword word = Keyword::none;
};

/// How many tokens of a file are kept.
struct PageBudget {
  std::size_t whole;   ///< a file of no more tokens than that keeps them all
  unsigned page_bits;  ///< others keep pages, of 2^page_bits tokens each,
  std::size_t pages;   ///< that many of them, at least 1
};
#ifdef FIRSTLIGHT_WATCHED
constexpr PageBudget kPageBudget{0, 4, 4};  // all files give up pages, so that whoever still looks there is found
#else
constexpr PageBudget kPageBudget{std::size_t{1} << 20, 12, 64};
#endif

/// A file cut into tokens; the last one is always TokenKind::end.
///
/// Links    Block directives are known without the tokens: skipping text is following links, not reading it.
/// Memory   All tokens, or, when they are too many for its PageBudget, pages of them: for one that is asked for, which
///          is cut again, the one that was cut the longest time ago is given up.
/// Threads  One at a time.
class TokenFile {
 public:
  /// Throws SyntaxError for what cannot be text of a scene, and for a loop or macro without #end. `source` and
  /// `symbols` must live as long.
  TokenFile(const SourceFile& source, Symbols& symbols, PageBudget budget = kPageBudget);
  TokenFile(const TokenFile&) = delete;
  TokenFile& operator=(const TokenFile&) = delete;

  const SourceFile& source() const { return *source_; }
  std::size_t size() const { return size_; }
  Token operator[](std::size_t index) const { return view(index); }
  Token back() const { return view(size_ - 1); }
  /// The token where it lies. It stays there until another is asked for; of a file that has all() as long as the file.
  const Token& view(std::size_t index) const { return all_ != nullptr ? all_[index] : on_page(index); }

  /// The first token when all stay where they lie, one behind the other; else null.
  const Token* all() const { return all_; }

  /// In the order of the text.
  std::span<const BlockDirective> blocks() const { return blocks_; }
  /// Place in that list of the first one whose `#` is not before `index`.
  std::size_t first_block_from(std::uint32_t index) const;
  /// Place in that list of the #end of the block that the one at `block` begins or is a branch of; 0 when the file ends
  /// before it.
  std::size_t end_of_block(std::size_t block) const;
  /// The index of the `#` of what follows the block directive at `hash` in the same block; kNoLink when the file ends
  /// before it, or that is no block directive.
  std::uint32_t link(std::uint32_t hash) const;

 private:
  struct Page {
    const Token* first = nullptr;  // null: not kept
    Lexer::Place begin;
  };
  struct KeptPage {
    std::size_t number = 0;
    std::vector<Token> tokens;
  };
  class BlockLinks;

  std::size_t page_size() const { return std::size_t{1} << budget_.page_bits; }
  [[gnu::noinline]] const Token& on_page(std::size_t index) const;  // so that view() stays short
  const Token* cut(std::size_t page) const;

  const SourceFile* source_;
  Symbols* symbols_;
  PageBudget budget_;
  std::size_t size_ = 0;
  std::vector<BlockDirective> blocks_;
  // A file that keeps them: all tokens.
  std::vector<Token> tokens_;
  const Token* all_ = nullptr;
  // One that gives up pages: all pages, and a ring of those that are kept. The next to be given up is at `oldest_`.
  mutable std::vector<Page> pages_;
  mutable std::vector<KeptPage> kept_;
  mutable std::size_t oldest_ = 0;
};

/// The index of the `#` of the `#end` that closes the block which the `#` at `hash` begins or is a branch of; kNoLink
/// when the file ends before it.
std::uint32_t end_of_block(const TokenFile& file, std::uint32_t hash);

}  // namespace firstlight::parser
