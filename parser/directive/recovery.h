#pragma once

#include "parser/text/syntax_error.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

namespace firstlight::parser {

class Interpreter;

/// The way on after a mistake: where reading goes on, and which further mistakes are only its consequences.
class Recovery {
 public:
  static constexpr std::size_t kMostMistakes = 20;   // told of in one run
  static constexpr std::size_t kMostFailures = 500;  // with those that follow from others

  explicit Recovery(Interpreter& in) : in_(in) {}

  /// After a mistake in a statement of the scene: tells of it, unless it is only the consequence of another, and goes
  /// on at the next statement. Throws it again when that is not possible.
  void recover(const SyntaxError& error);
  /// Tells of a mistake after which the scene cannot be rendered but can be read further.
  void report(const SyntaxError& error);
  bool has_failed() const { return failures_ > 0; }

 private:
  bool is_consequence(const SyntaxError& error) const;
  std::string standard_file_hint(std::string_view name) const;
  [[noreturn]] void give_up();
  std::uint32_t next_statement(std::uint32_t start, std::uint32_t reached) const;
  bool may_begin_statement(std::uint32_t index) const;
  void note_broken_names(std::uint32_t begin, std::uint32_t end);

  Interpreter& in_;
  // Mistakes so far, and what their consequences are known by.
  std::size_t mistakes_ = 0, failures_ = 0;
  bool include_failed_ = false;
  std::set<std::tuple<std::string, std::size_t, std::size_t>> reported_places_;  // file, line, column
  std::set<std::uint32_t> broken_names_;
};

}  // namespace firstlight::parser
