#include "parser/text/token_file.h"

#include "parser/text/syntax_error.h"

#include <algorithm>
#include <string>
#include <utility>

namespace firstlight::parser {

namespace {

bool must_close_in_its_file(Keyword word) {
  return word == Keyword::while_ || word == Keyword::for_ || word == Keyword::macro;
}

bool parts_block(Keyword word) {
  return word == Keyword::else_ || word == Keyword::elseif || word == Keyword::case_ || word == Keyword::range;
}

}  // namespace

/// Sets the links between the parts of block directives, while a file is cut.
class TokenFile::BlockLinks {
 public:
  explicit BlockLinks(std::vector<BlockDirective>& blocks) : blocks_(blocks) {}

  /// `word` stands behind the `#` at `hash`.
  void add(const Token& word, std::uint32_t hash) {
    const bool opens = opens_block(word.keyword), ends = word.is(Keyword::end);
    if (!opens && !ends && !parts_block(word.keyword)) return;
    const auto here = static_cast<std::uint32_t>(blocks_.size());
    blocks_.push_back({.hash = hash, .word = word.keyword});
    if (opens) {
      open_.push_back({here, here});
    } else if (!open_.empty()) {
      blocks_[open_.back().last].follower = here;
      open_.back().last = here;
      if (ends) open_.pop_back();
    }
  }

  /// A branch may end in the file that includes this one; a loop or a macro may not.
  void check_closed(const TokenFile& file) {
    std::erase_if(open_, [&](const Open& block) { return !must_close_in_its_file(blocks_[block.opener].word); });
    if (open_.empty()) return;
    const Token word = file[blocks_[open_.back().opener].hash + 1];
    const Location end = file.back().location;
    const SourceFile& source = file.source();
    const auto message = "expected '#end' to close '#" + std::string(word.text) + "', found end of file";
    throw SyntaxError({diagnostic_at(source, end, render::Diagnostic::Severity::error, message),
                       diagnostic_at(source, word.location, render::Diagnostic::Severity::note,
                                     "'#" + std::string(word.text) + "' opened here")});
  }

 private:
  struct Open {
    std::uint32_t opener;
    std::uint32_t last;  // the part whose follower is not known yet
  };
  std::vector<BlockDirective>& blocks_;
  std::vector<Open> open_;
};

TokenFile::TokenFile(const SourceFile& source, Symbols& symbols, PageBudget budget)
    : source_(&source), symbols_(&symbols), budget_(budget) {
  Lexer lexer(source, symbols);
  BlockLinks links(blocks_);
  tokens_.reserve(std::min(source.text.size() / 4 + 1, budget_.whole));
  bool is_behind_hash = false;
  for (bool ends = false; !ends; ++size_) {
    const bool is_kept = size_ < budget_.whole;
    const Token token = is_kept ? lexer.next() : lexer.next_in_outline();
    if (size_ % page_size() == 0) pages_.push_back({nullptr, lexer.place()});
    if (is_kept) tokens_.push_back(token);
    if (is_behind_hash) links.add(token, static_cast<std::uint32_t>(size_ - 1));
    is_behind_hash = token.is(Punctuation::hash);
    ends = token.is_end();
  }
  if (size_ == tokens_.size()) {
    all_ = tokens_.data();
    std::vector<Page>().swap(pages_);
  } else {
    std::vector<Token>().swap(tokens_);
  }
  blocks_.shrink_to_fit();
  pages_.shrink_to_fit();
  links.check_closed(*this);
}

const Token& TokenFile::on_page(std::size_t index) const {
  const std::size_t page = index >> budget_.page_bits;
  const Token* tokens = pages_[page].first;
  if (tokens == nullptr) tokens = cut(page);
  return tokens[index & (page_size() - 1)];
}

const Token* TokenFile::cut(std::size_t number) const {
  if (kept_.size() < budget_.pages) {
    oldest_ = kept_.size();
    kept_.emplace_back();
  } else {
    pages_[kept_[oldest_].number].first = nullptr;
  }
  KeptPage& page = kept_[oldest_];
  oldest_ = (oldest_ + 1) % budget_.pages;
  page = {number, {}};
  const std::size_t count = std::min(page_size(), size_ - number * page_size());
  page.tokens.reserve(count);
  Lexer lexer(*source_, *symbols_, pages_[number].begin);
  while (page.tokens.size() < count) page.tokens.push_back(lexer.next());
  return pages_[number].first = page.tokens.data();
}

std::size_t TokenFile::first_block_from(std::uint32_t index) const {
  const auto found = std::ranges::lower_bound(blocks_, index, {}, &BlockDirective::hash);
  return static_cast<std::size_t>(found - blocks_.begin());
}

std::size_t TokenFile::end_of_block(std::size_t block) const {
  do {
    block = blocks_[block].follower;
  } while (block != 0 && blocks_[block].word != Keyword::end);
  return block;
}

std::uint32_t TokenFile::link(std::uint32_t hash) const {
  const std::size_t block = first_block_from(hash);
  if (block == blocks_.size() || blocks_[block].hash != hash || blocks_[block].follower == 0) return kNoLink;
  return blocks_[blocks_[block].follower].hash;
}

std::uint32_t end_of_block(const TokenFile& file, std::uint32_t hash) {
  const std::size_t block = file.first_block_from(hash);
  if (block == file.blocks().size() || file.blocks()[block].hash != hash) return kNoLink;
  const std::size_t end = file.end_of_block(block);
  return end == 0 ? kNoLink : file.blocks()[end].hash;
}

}  // namespace firstlight::parser
