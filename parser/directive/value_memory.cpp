#include "parser/directive/value_memory.h"

#include "parser/directive/interpreter.h"

#include <algorithm>
#include <string>

namespace firstlight::parser {

void ValueMemory::charge(const Value& value, const Location& at) {
  charged_ += bytes_of(value);
  if (charged_ <= std::max(next_count_, in_.options().value_memory / 4)) return;
  charged_ = bytes_of(value) + in_.scopes().bytes();
  if (charged_ > in_.options().value_memory) {
    in_.fail_finally(at, "the strings and arrays of this scene are too large (limit " +
                             std::to_string(in_.options().value_memory >> 20) + " MiB)");
  }
  next_count_ = charged_ + in_.options().value_memory / 4;
}

}  // namespace firstlight::parser
