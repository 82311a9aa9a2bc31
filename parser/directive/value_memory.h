#pragma once

#include "parser/text/token.h"
#include "parser/text/value.h"

#include <cstddef>

namespace firstlight::parser {

class Interpreter;

/// The memory that strings, arrays and dictionaries of a scene may take up: a scene is untrusted. They are counted as
/// they are made, and only when that is much are those counted that are still there.
class ValueMemory {
 public:
  explicit ValueMemory(Interpreter& in) : in_(in) {}

  /// For a value that has been made; fails at `at` when all that there are take too much.
  void charge(const Value& value, const Location& at);
  /// For bytes that the next value is charged with.
  void add(std::size_t bytes) { charged_ += bytes; }

 private:
  Interpreter& in_;
  std::size_t charged_ = 0, next_count_ = 0;  // bytes made since they were counted, with what was counted then
};

}  // namespace firstlight::parser
