#include "priority/scheme_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <system_error>

namespace firstlight::priority {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

void SchemeText::skip_blanks() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
}

bool SchemeText::at_end() {
  skip_blanks();
  return at_ == text_.size();
}

bool SchemeText::next_is(char mark) { return !at_end() && text_[at_] == mark; }
bool SchemeText::at_word() { return !at_end() && is_letter(text_[at_]); }

bool SchemeText::at_number() {
  if (at_end()) return false;
  return is_digit(text_[at_]) || (text_[at_] == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]));
}

bool SchemeText::accept(char mark) {
  if (!next_is(mark)) return false;
  ++at_;
  return true;
}

void SchemeText::expect(char mark, std::string_view purpose) {
  if (!accept(mark)) fail_expected(fmt::format("'{}' {}", mark, purpose));
}

Piece SchemeText::name(std::span<const std::string_view> known) {
  if (!at_word()) fail_expected("the name of a scheme");
  std::size_t end = at_;
  std::size_t longest_known = 0;
  for (;;) {
    while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
    if (std::ranges::find(known, text_.substr(at_, end - at_)) != known.end()) longest_known = end;
    if (end + 1 >= text_.size() || text_[end] != '-' || !is_letter(text_[end + 1])) break;
    ++end;
  }
  if (longest_known != 0) end = longest_known;
  const Piece piece{text_.substr(at_, end - at_), at_};
  at_ = end;
  return piece;
}

Piece SchemeText::identifier(std::string_view what) {
  if (!at_word()) fail_expected(what);
  const Piece piece = next();
  at_ += piece.text.size();
  return piece;
}

double SchemeText::number(std::string_view what) {
  if (!at_number()) fail_expected(what);
  double value = 0.0;
  const char* const first = text_.data() + at_;
  const auto [end, problem] = std::from_chars(first, text_.data() + text_.size(), value);
  const auto length = static_cast<std::size_t>(end - first);
  if (problem != std::errc() || !std::isfinite(value))
    fail({text_.substr(at_, length), at_}, "the number is too large");
  at_ += length;
  return value;
}

int SchemeText::integer(std::string_view what) {
  skip_blanks();
  int value = 0;
  const char* const first = text_.data() + at_;
  const auto [end, problem] = std::from_chars(first, text_.data() + text_.size(), value);
  if (problem == std::errc::result_out_of_range) fail(next(), "the number is too large");
  if (problem != std::errc()) fail_expected(what);
  at_ += static_cast<std::size_t>(end - first);
  return value;
}

Piece SchemeText::rest_of_parenthesis() {
  const std::size_t begin = at_;
  int open = 1;
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '(') ++open;
    if (text_[at_] == ')' && --open == 0) break;
  }
  return {text_.substr(begin, at_ - begin), begin};
}

Piece SchemeText::next() {
  skip_blanks();
  std::size_t end = at_;
  while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
  if (end == at_ && end < text_.size()) ++end;
  return {text_.substr(at_, end - at_), at_};
}

void SchemeText::fail(const Piece& where, std::string message) const {
  throw SchemeError{where.at, std::max<std::size_t>(where.text.size(), 1), std::move(message)};
}

void SchemeText::fail_expected(std::string_view what) {
  const Piece found = next();
  fail(found, fmt::format("expected {}, found {}", what,
                          found.text.empty() ? std::string("the end") : fmt::format("'{}'", found.text)));
}

Ranks read_ranks(SchemeText& text, std::string_view what, std::span<const std::string_view> words) {
  const auto unnamed = static_cast<std::uint32_t>(words.size());
  Ranks ranks;
  ranks.of.assign(words.size(), unnamed);
  do {
    const Piece word = text.identifier(what);
    const auto found = std::ranges::find(words, word.text);
    if (found == words.end()) {
      text.fail(word, fmt::format("expected {}, found '{}'; there are {}", what, word.text, fmt::join(words, ", ")));
    }
    std::uint32_t& place = ranks.of[static_cast<std::size_t>(found - words.begin())];
    if (place != unnamed) text.fail(word, fmt::format("'{}' is named twice", word.text));
    place = ranks.named++;
    text.accept(',');
  } while (!text.next_is(')') && !text.at_end());
  std::uint32_t next = ranks.named;
  for (std::uint32_t& place : ranks.of) {
    if (place == unnamed) place = next++;
  }
  return ranks;
}

std::string nearest_hint(std::string_view word, std::span<const std::string_view> known) {
  std::string_view best;
  std::size_t fewest = std::max<std::size_t>(1, (word.size() + 1) / 3) + 1;
  for (const std::string_view candidate : known) {
    // Longer differences than allowed need not be counted.
    if (candidate.size() + fewest <= word.size() || word.size() + fewest <= candidate.size()) continue;
    if (const std::size_t edits = edit_distance(word, candidate); edits < fewest) {
      fewest = edits;
      best = candidate;
    }
  }
  return best.empty() ? std::string() : fmt::format(" (the nearest is '{}')", best);
}

std::string format(const SchemeError& error, std::string_view text) {
  std::string line;
  // Line ends and tabs would move the caret away.
  for (const char c : text) line += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  const std::size_t length =
      std::max<std::size_t>(1, std::min(error.length, text.size() - std::min(error.at, text.size())));
  return fmt::format("column {}: {}\n  {}\n  {:{}}^{:~<{}}", error.at + 1, error.message, line, "", error.at, "",
                     length - 1);
}

}  // namespace firstlight::priority
