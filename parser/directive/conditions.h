#pragma once

#include "parser/text/scope.h"
#include "parser/text/token.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace firstlight::parser {

class Interpreter;

/// `#if`, `#switch`, `#while`, `#for`: the choices and loops that are open. What is skipped is jumped over by the links
/// between the tokens of block directives.
///
/// Terms    `word` is that of the directive, `hash` the index of the `#` before it, in the file that is being read.
class Conditions {
 public:
  explicit Conditions(Interpreter& in) : in_(in) {}

  /// `#if`, `#ifdef`, `#ifndef`
  void run_if(const Token& word, std::uint32_t hash);
  /// `#else`, `#elseif`, `#case`, `#range`
  void run_further_branch(const Token& word, std::uint32_t hash);
  void run_switch(const Token& word, std::uint32_t hash);
  void run_while(const Token& word, std::uint32_t hash);
  void run_for(const Token& word, std::uint32_t hash);
  void run_end(const Token& word, std::uint32_t hash);
  void run_break(const Token& word);

  /// At the end of the scene: fails if one is open.
  void check_closed();
  // After a mistake those are forgotten that were opened in a frame which has been left, that begin at `start` or behind
  // it in this one, or the innermost of this one.
  void forget_left();
  void forget_since(std::uint32_t start);
  void forget_innermost();

 private:
  /// A loop or a choice whose `#end` has not been reached.
  struct Condition {
    enum class Kind { if_, while_, for_, switch_ };
    Kind kind = Kind::if_;
    Token word;                       // of its first directive
    std::size_t frame = 0;            // depth of the frame it is in
    std::uint32_t hash = 0;           // of its first directive; of #switch: of the case that applies
    std::uint32_t body = 0;           // of #for: behind its parentheses
    Scopes::Slot variable = nullptr;  // of #for
    double end = 0.0, step = 0.0;
  };

  bool condition_holds();
  bool case_applies(Keyword word, double value);
  std::uint32_t next_branch(std::uint32_t hash, const Token& word);
  std::uint32_t find_branch(std::uint32_t index) const;
  Token word_of_directive(std::uint32_t hash) const;
  void skip_to_end(std::uint32_t hash, const Token& word);
  [[noreturn]] void fail_unclosed(const Token& word);
  bool in_choice(Condition::Kind kind) const;
  bool in_block() const;
  static bool for_continues(const Condition& loop);
  bool turn_again(Condition& loop, const Token& word);
  void check_same_frame(std::size_t frames, const Token& word);

  Interpreter& in_;
  std::vector<Condition> open_;  // the innermost last
};

}  // namespace firstlight::parser
