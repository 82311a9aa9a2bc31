// #if, #switch, #while, #for: what is skipped is jumped over by the links between the tokens of block directives.
#include "parser/directive/interpreter.h"
#include "parser/directive/reader.h"
#include "parser/expression/expression.h"

#include <cmath>

namespace firstlight::parser {

namespace {

std::string hash_word(const Token& word) { return "'#" + std::string(word.text) + "'"; }

}  // namespace

bool Interpreter::condition_holds() { return is_true(parse_condition(*this)); }

void Interpreter::check_same_frame(std::size_t frames, const Token& word) {
  unsettle();
  if (frames_.size() != frames) {
    fail(word.location,
         "the parentheses behind " + hash_word(word) + " must close in the file or macro where they open");
  }
}

// The index of the `#` of the `#end` of the loop or macro that `hash` belongs to.
std::uint32_t Interpreter::end_of_block(std::uint32_t hash) const {
  const std::vector<Token>& tokens = frames_.back().file->tokens;
  do {
    hash = tokens[hash].symbol;
  } while (hash != kNoLink && !tokens[hash + 1].is(Keyword::end));
  return hash;
}

// The index of the `#` of what follows the part at `hash` in its block. A branch may go on behind the end of its file,
// in the file that includes it; then that file is the innermost frame.
std::uint32_t Interpreter::next_branch(std::uint32_t hash, const Token& word) {
  std::uint32_t next = frames_.back().file->tokens[hash].symbol;
  if (next == kNoLink) next = find_branch(hash + 2);
  while (next == kNoLink) {
    if (frames_.size() == 1 || frames_.back().macro) fail_unclosed(word);
    leave_frame();
    next = find_branch(frames_.back().position);
  }
  return next;
}

// The first #else, #elseif, #case, #range or #end from `index` on that belongs to no block which begins there.
std::uint32_t Interpreter::find_branch(std::uint32_t index) const {
  const std::vector<Token>& tokens = frames_.back().file->tokens;
  for (; index < frames_.back().end; ++index) {
    if (!tokens[index].is(Punctuation::hash)) continue;
    if (opens_block(tokens[index + 1].keyword)) {
      index = end_of_block(index);
      if (index == kNoLink) return kNoLink;
      continue;
    }
    switch (tokens[index + 1].keyword) {
      case Keyword::else_:
      case Keyword::elseif:
      case Keyword::case_:
      case Keyword::range:
      case Keyword::end:
        return index;
      default:
        break;
    }
  }
  return kNoLink;
}

void Interpreter::skip_to_end(std::uint32_t hash, const Token& word) {
  do {
    hash = next_branch(hash, word);
  } while (!frames_.back().file->tokens[hash + 1].is(Keyword::end));
  go_behind(hash);
}

void Interpreter::fail_unclosed(const Token& word) {
  fail(frames_.back().file->tokens.back().location,
       "expected '#end' to close " + hash_word(word) + ", found end of file", word.location,
       hash_word(word) + " opened here");
}

// Whether the innermost block is one that may have branches here: one of this file or macro, or a choice in the file
// that includes this one, or in one that this file has included.
bool Interpreter::in_choice(Condition::Kind kind) const {
  if (conditions_.empty() || conditions_.back().kind != kind) return false;
  for (std::size_t frame = conditions_.back().frame; frame < frames_.size(); ++frame) {
    if (frames_[frame].macro) return false;
  }
  return true;
}

void Interpreter::go_behind(std::uint32_t end) { frames_.back().position = end + 2; }

void Interpreter::run_if(const Token& word, std::uint32_t hash) {
  const std::size_t frames = frames_.size();
  const bool named = word.is(Keyword::ifdef) || word.is(Keyword::ifndef);
  bool holds = named ? parse_defined() == word.is(Keyword::ifdef) : condition_holds();
  check_same_frame(frames, word);
  for (std::uint32_t branch = hash; !holds;) {
    branch = next_branch(branch, word);
    const Token& next = frames_.back().file->tokens[branch + 1];
    const std::size_t frames_of_branch = frames_.size();
    go_behind(branch);
    if (next.is(Keyword::end)) return;
    if (next.is(Keyword::elseif)) {
      holds = condition_holds();
      check_same_frame(frames_of_branch, next);
    } else if (next.is(Keyword::else_)) {
      holds = true;
    } else {
      fail(next.location, hash_word(next) + " does not belong to " + hash_word(word), word.location,
           hash_word(word) + " is here");
    }
  }
  conditions_.push_back({.kind = Condition::Kind::if_, .word = &word, .frame = frames_.size(), .hash = hash});
}

// A branch begins where the one before it, which was read, ends.
void Interpreter::run_further_branch(const Token& word, std::uint32_t hash) {
  const bool of_if = word.is(Keyword::else_) || word.is(Keyword::elseif);
  if (in_choice(Condition::Kind::if_) && of_if) {
    const Token& opener = *conditions_.back().word;
    conditions_.pop_back();
    return skip_to_end(hash, opener);
  }
  if (in_choice(Condition::Kind::switch_) && !word.is(Keyword::elseif)) {
    // Without a #break, reading goes on into the next case.
    const std::size_t frames = frames_.size();
    if (!word.is(Keyword::else_)) case_applies(word.keyword, 0.0);
    return check_same_frame(frames, word);
  }
  fail_unbalanced(word.location, of_if ? hash_word(word) + " without '#if'" : hash_word(word) + " without '#switch'");
}

bool Interpreter::case_applies(Keyword word, double value) {
  if (word == Keyword::case_) return std::abs(parse_condition(*this) - value) < kSmallestTrue;
  const auto [low, high] = parse_two_numbers(*this);
  return value >= low && value <= high;
}

void Interpreter::run_switch(const Token& word, std::uint32_t hash) {
  const std::size_t frames = frames_.size();
  const double value = parse_condition(*this);
  check_same_frame(frames, word);
  std::uint32_t branch = hash;
  for (bool applies = false; !applies;) {
    const bool first = branch == hash;
    branch = next_branch(branch, word);
    const Token& next = frames_.back().file->tokens[branch + 1];
    if (first && (frames_.back().position != branch || next.is(Keyword::end))) {
      fail(raw_next().location, "expected '#case' or '#range' after '#switch', found " + describe(raw_next()));
    }
    go_behind(branch);
    if (next.is(Keyword::end)) return;
    if (next.is(Keyword::else_)) break;
    if (next.is(Keyword::elseif)) fail(next.location, "'#elseif' without '#if'");
    const std::size_t frames_of_branch = frames_.size();
    applies = case_applies(next.keyword, value);
    check_same_frame(frames_of_branch, next);
  }
  conditions_.push_back({.kind = Condition::Kind::switch_, .word = &word, .frame = frames_.size(), .hash = branch});
}

void Interpreter::run_while(const Token& word, std::uint32_t hash) {
  const std::size_t frames = frames_.size();
  const bool holds = condition_holds();
  check_same_frame(frames, word);
  if (holds) {
    conditions_.push_back({.kind = Condition::Kind::while_, .word = &word, .frame = frames, .hash = hash});
  } else {
    go_behind(end_of_block(hash));
  }
}

void Interpreter::run_for(const Token& word, std::uint32_t hash) {
  const std::size_t frames = frames_.size();
  Reader reader(*this);
  Condition loop;
  loop.kind = Condition::Kind::for_;
  loop.word = &word;
  loop.frame = frames;
  loop.hash = hash;
  expect(Punctuation::left_paren, "after '#for'");
  const Token& name = take_identifier(word);
  loop.variable = scopes_.target(name.symbol, true);
  reader.skip_comma();
  Numbers start;
  start.values[0] = reader.number();
  reader.skip_comma();
  loop.end = reader.number();
  reader.skip_comma();
  const Token& at = peek();
  loop.step = reader.at_expression() ? reader.number() : 1.0;
  if (!(std::abs(loop.step) >= kSmallestTrue))
    fail(at.location, "expected a step that is not 0 for '#for', found " + describe(at));
  expect(Punctuation::right_paren, "to close '#for'");
  check_same_frame(frames, word);
  loop.body = frames_.back().position;
  *loop.variable = start;
  if (for_continues(loop)) {
    conditions_.push_back(loop);
  } else {
    go_behind(end_of_block(hash));
  }
}

bool Interpreter::for_continues(const Condition& loop) const {
  const double value = std::get<Numbers>(*loop.variable).values[0];
  return loop.step > 0.0 ? value <= loop.end + kSmallestTrue : value >= loop.end - kSmallestTrue;
}

void Interpreter::run_end(const Token& word, std::uint32_t hash) {
  const bool of_choice = in_choice(Condition::Kind::if_) || in_choice(Condition::Kind::switch_);
  if (!in_block() && !of_choice) {
    fail_unbalanced(word.location, "'#end' without '#if', '#switch', '#while', '#for' or '#macro'");
  }
  Condition& block = conditions_.back();
  const bool is_loop = block.kind == Condition::Kind::while_ || block.kind == Condition::Kind::for_;
  if (is_loop && turn_again(block, word)) return;
  if (is_loop) go_behind(hash);
  conditions_.pop_back();
}

bool Interpreter::turn_again(Condition& loop, const Token& word) {
  count_step(word.location);
  if (loop.kind == Condition::Kind::while_) {
    const std::size_t frames = frames_.size();
    go_behind(loop.hash);
    const bool holds = condition_holds();
    check_same_frame(frames, word);
    return holds;
  }
  auto* number = std::get_if<Numbers>(loop.variable.get());
  if (number == nullptr || number->size != 1) {
    fail(word.location, "expected the variable of '#for' to be a float at the end of the loop, found " +
                            std::string(kind_name(*loop.variable)));
  }
  number->values[0] += loop.step;
  if (!for_continues(loop)) return false;
  // The text behind the closing parenthesis was found when the loop began.
  frames_.back().position = loop.body;
  return true;
}

void Interpreter::run_break(const Token& word) {
  while (in_block()) {
    const Condition block = conditions_.back();
    conditions_.pop_back();
    if (block.kind == Condition::Kind::switch_) return skip_to_end(block.hash, *block.word);
    if (block.kind != Condition::Kind::if_) return go_behind(end_of_block(block.hash));
  }
  if (frames_.back().macro == nullptr) fail(word.location, "'#break' outside of a loop, '#switch' or macro");
  frames_.back().position = frames_.back().end;  // leaves the macro
}

}  // namespace firstlight::parser
