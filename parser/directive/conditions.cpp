// #if, #switch, #while, #for: what is skipped is jumped over by the links between block directives.
#include "parser/directive/conditions.h"

#include "parser/directive/interpreter.h"
#include "parser/directive/reader.h"
#include "parser/expression/expression.h"

#include <cmath>
#include <span>

namespace firstlight::parser {

namespace {

std::string hash_word(const Token& word) { return "'#" + std::string(word.text) + "'"; }

}  // namespace

bool Conditions::condition_holds() { return is_true(parse_condition(in_)); }

void Conditions::check_same_frame(std::size_t frames, const Token& word) {
  in_.unsettle();
  if (in_.frames().size() != frames) {
    in_.fail(word.location,
             "the parentheses behind " + hash_word(word) + " must close in the file or macro where they open");
  }
}

// The index of the `#` of what follows the part at `hash` in its block. A branch may go on behind the end of its file,
// in the file that includes it; then that file is the innermost frame.
std::uint32_t Conditions::next_branch(std::uint32_t hash, const Token& word) {
  std::uint32_t next = in_.frame().file->link(hash);
  if (next == kNoLink) next = find_branch(hash + 2);
  while (next == kNoLink) {
    if (in_.frames().size() == 1 || in_.frame().macro) fail_unclosed(word);
    in_.leave_frame();
    next = find_branch(in_.frame().position);
  }
  return next;
}

// The first #else, #elseif, #case, #range or #end from `index` on that belongs to no block which begins there.
std::uint32_t Conditions::find_branch(std::uint32_t index) const {
  const TokenFile& file = *in_.frame().file;
  const std::span<const BlockDirective> blocks = file.blocks();
  for (std::size_t i = file.first_block_from(index); i < blocks.size() && blocks[i].hash < in_.frame().end; ++i) {
    if (!opens_block(blocks[i].word)) return blocks[i].hash;
    i = file.end_of_block(i);
    if (i == 0) return kNoLink;
  }
  return kNoLink;
}

Token Conditions::word_of_directive(std::uint32_t hash) const { return (*in_.frame().file)[hash + 1]; }

void Conditions::skip_to_end(std::uint32_t hash, const Token& word) {
  do {
    hash = next_branch(hash, word);
  } while (!word_of_directive(hash).is(Keyword::end));
  in_.go_behind(hash);
}

void Conditions::check_closed() {
  if (!open_.empty()) fail_unclosed(open_.back().word);
}

void Conditions::forget_since(std::uint32_t start) {
  std::erase_if(open_, [&](const Condition& condition) {
    return condition.frame == in_.frames().size() && condition.hash >= start;
  });
}

void Conditions::forget_left() {
  std::erase_if(open_, [&](const Condition& condition) { return condition.frame > in_.frames().size(); });
}

void Conditions::forget_innermost() {
  if (in_block()) open_.pop_back();
}

bool Conditions::in_block() const { return !open_.empty() && open_.back().frame == in_.frames().size(); }

void Conditions::fail_unclosed(const Token& word) {
  in_.fail(in_.frame().file->back().location, "expected '#end' to close " + hash_word(word) + ", found end of file",
           word.location, hash_word(word) + " opened here");
}

// Whether the innermost block is one that may have branches here: one of this file or macro, or a choice in the file
// that includes this one, or in one that this file has included.
bool Conditions::in_choice(Condition::Kind kind) const {
  if (open_.empty() || open_.back().kind != kind) return false;
  for (std::size_t frame = open_.back().frame; frame < in_.frames().size(); ++frame) {
    if (in_.frames()[frame].macro) return false;
  }
  return true;
}

void Conditions::run_if(const Token& word, std::uint32_t hash) {
  const std::size_t frames = in_.frames().size();
  const bool named = word.is(Keyword::ifdef) || word.is(Keyword::ifndef);
  bool holds = named ? in_.parse_defined() == word.is(Keyword::ifdef) : condition_holds();
  check_same_frame(frames, word);
  for (std::uint32_t branch = hash; !holds;) {
    branch = next_branch(branch, word);
    const Token next = word_of_directive(branch);
    const std::size_t frames_of_branch = in_.frames().size();
    in_.go_behind(branch);
    if (next.is(Keyword::end)) return;
    if (next.is(Keyword::elseif)) {
      holds = condition_holds();
      check_same_frame(frames_of_branch, next);
    } else if (next.is(Keyword::else_)) {
      holds = true;
    } else {
      in_.fail(next.location, hash_word(next) + " does not belong to " + hash_word(word), word.location,
               hash_word(word) + " is here");
    }
  }
  open_.push_back({.kind = Condition::Kind::if_, .word = word, .frame = in_.frames().size(), .hash = hash});
}

// A branch begins where the one before it, which was read, ends.
void Conditions::run_further_branch(const Token& word, std::uint32_t hash) {
  const bool of_if = word.is(Keyword::else_) || word.is(Keyword::elseif);
  if (in_choice(Condition::Kind::if_) && of_if) {
    const Token opener = open_.back().word;
    open_.pop_back();
    return skip_to_end(hash, opener);
  }
  if (in_choice(Condition::Kind::switch_) && !word.is(Keyword::elseif)) {
    // Without a #break, reading goes on into the next case.
    const std::size_t frames = in_.frames().size();
    if (!word.is(Keyword::else_)) case_applies(word.keyword, 0.0);
    return check_same_frame(frames, word);
  }
  in_.fail_unbalanced(word.location,
                      of_if ? hash_word(word) + " without '#if'" : hash_word(word) + " without '#switch'");
}

bool Conditions::case_applies(Keyword word, double value) {
  if (word == Keyword::case_) return std::abs(parse_condition(in_) - value) < kSmallestTrue;
  const auto [low, high] = parse_two_numbers(in_);
  return value >= low && value <= high;
}

void Conditions::run_switch(const Token& word, std::uint32_t hash) {
  const std::size_t frames = in_.frames().size();
  const double value = parse_condition(in_);
  check_same_frame(frames, word);
  std::uint32_t branch = hash;
  for (bool applies = false; !applies;) {
    const bool first = branch == hash;
    branch = next_branch(branch, word);
    const Token next = word_of_directive(branch);
    if (first && (in_.frame().position != branch || next.is(Keyword::end))) {
      in_.fail(in_.raw_next().location,
               "expected '#case' or '#range' after '#switch', found " + describe(in_.raw_next()));
    }
    in_.go_behind(branch);
    if (next.is(Keyword::end)) return;
    if (next.is(Keyword::else_)) break;
    if (next.is(Keyword::elseif)) in_.fail(next.location, "'#elseif' without '#if'");
    const std::size_t frames_of_branch = in_.frames().size();
    applies = case_applies(next.keyword, value);
    check_same_frame(frames_of_branch, next);
  }
  open_.push_back({.kind = Condition::Kind::switch_, .word = word, .frame = in_.frames().size(), .hash = branch});
}

void Conditions::run_while(const Token& word, std::uint32_t hash) {
  const std::size_t frames = in_.frames().size();
  const bool holds = condition_holds();
  check_same_frame(frames, word);
  if (holds) {
    open_.push_back({.kind = Condition::Kind::while_, .word = word, .frame = frames, .hash = hash});
  } else {
    in_.go_behind(end_of_block(*in_.frame().file, hash));
  }
}

void Conditions::run_for(const Token& word, std::uint32_t hash) {
  const std::size_t frames = in_.frames().size();
  Reader reader(in_);
  Condition loop;
  loop.kind = Condition::Kind::for_;
  loop.word = word;
  loop.frame = frames;
  loop.hash = hash;
  in_.expect(Punctuation::left_paren, "after '#for'");
  const Token& name = in_.take_identifier(word);
  loop.variable = in_.scopes().target(name.symbol, true);
  reader.skip_comma();
  Numbers start;
  start.values[0] = reader.number();
  reader.skip_comma();
  loop.end = reader.number();
  reader.skip_comma();
  const Token& at = in_.peek();
  loop.step = reader.at_expression() ? reader.number() : 1.0;
  if (!(std::abs(loop.step) >= kSmallestTrue))
    in_.fail(at.location, "expected a step that is not 0 for '#for', found " + describe(at));
  in_.expect(Punctuation::right_paren, "to close '#for'");
  check_same_frame(frames, word);
  loop.body = in_.frame().position;
  *loop.variable = start;
  if (for_continues(loop)) {
    open_.push_back(loop);
  } else {
    in_.go_behind(end_of_block(*in_.frame().file, hash));
  }
}

bool Conditions::for_continues(const Condition& loop) {
  const double value = std::get<Numbers>(*loop.variable).values[0];
  return loop.step > 0.0 ? value <= loop.end + kSmallestTrue : value >= loop.end - kSmallestTrue;
}

void Conditions::run_end(const Token& word, std::uint32_t hash) {
  const bool of_choice = in_choice(Condition::Kind::if_) || in_choice(Condition::Kind::switch_);
  if (!in_block() && !of_choice) {
    in_.fail_unbalanced(word.location, "'#end' without '#if', '#switch', '#while', '#for' or '#macro'");
  }
  Condition& block = open_.back();
  const bool is_loop = block.kind == Condition::Kind::while_ || block.kind == Condition::Kind::for_;
  if (is_loop && turn_again(block, word)) return;
  if (is_loop) in_.go_behind(hash);
  open_.pop_back();
}

bool Conditions::turn_again(Condition& loop, const Token& word) {
  in_.count_step(word.location);
  if (loop.kind == Condition::Kind::while_) {
    const std::size_t frames = in_.frames().size();
    in_.go_behind(loop.hash);
    const bool holds = condition_holds();
    check_same_frame(frames, word);
    return holds;
  }
  auto* number = std::get_if<Numbers>(loop.variable.get());
  if (number == nullptr || number->size != 1) {
    in_.fail(word.location, "expected the variable of '#for' to be a float at the end of the loop, found " +
                                std::string(kind_name(*loop.variable)));
  }
  number->values[0] += loop.step;
  if (!for_continues(loop)) return false;
  // The text behind the closing parenthesis was found when the loop began.
  in_.frame().position = loop.body;
  return true;
}

void Conditions::run_break(const Token& word) {
  while (in_block()) {
    const Condition block = open_.back();
    open_.pop_back();
    if (block.kind == Condition::Kind::switch_) return skip_to_end(block.hash, block.word);
    if (block.kind != Condition::Kind::if_) return in_.go_behind(end_of_block(*in_.frame().file, block.hash));
  }
  if (in_.frame().macro == nullptr) in_.fail(word.location, "'#break' outside of a loop, '#switch' or macro");
  in_.frame().position = in_.frame().end;  // leaves the macro
}

}  // namespace firstlight::parser
