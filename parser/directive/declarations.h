#pragma once

#include "parser/directive/containers.h"
#include "parser/text/scope.h"
#include "parser/text/token.h"
#include "parser/text/value.h"

#include <cstdint>
#include <vector>

namespace firstlight::parser {

class Interpreter;

/// `#declare` and `#local`, and the values that they, elements of arrays and calls of macros take.
class Declarations {
 public:
  explicit Declarations(Interpreter& in) : in_(in) {}

  /// `after_hash` is false for the old `declare` without `#`.
  void run_declare(const Token& word, bool after_hash);

  /// The place that a value is stored in.
  struct Target {
    Token name;
    Scopes::Slot slot;
    Containers::Part part;  ///< when it is a part of an array or a dictionary
    bool optional = false;  ///< of several: may get no value
  };
  /// The name, or part of what has that name, behind `word`.
  Target parse_target(const Token& word);
  void store(const Target& target, Value value);

  /// A value, and the slot of the name that it was read from, when it was a single name.
  struct Argument {
    Value value;
    Scopes::Slot reference;
    bool needs_semicolon = false;
  };
  /// A value as it may be declared or handed to a macro. A name alone is handed on by reference to a macro's `parameter`,
  /// if the macro's caller has it.
  Argument parse_argument(bool parameter);
  /// Where an optional value is due: whether there is none.
  bool next_is_left_out();

 private:
  bool declare_by_formula(const Token& word);
  void check_semicolon(const Target& target, const Token& word);
  // several_declare.cpp
  void run_several_declare(const Token& word);
  std::vector<Target> parse_targets(const Token& word, Punctuation closing);
  void store_tuple(const std::vector<Target>& targets);
  void store_components(const std::vector<Target>& targets);
  void store_elements(const std::vector<Target>& targets);

  Interpreter& in_;
};

}  // namespace firstlight::parser
