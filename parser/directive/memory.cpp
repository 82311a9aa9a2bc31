// What the values of a scene may take up: a scene is untrusted.
#include "parser/directive/interpreter.h"

#include <algorithm>
#include <string>

namespace firstlight::parser {

// Values are counted as they are made, and only when that is much are those counted that are still there.
void Interpreter::charge(const Value& value, const Location& at) {
  charged_ += bytes_of(value);
  if (charged_ <= std::max(next_count_, options_.value_memory / 4)) return;
  charged_ = bytes_of(value) + scopes_.bytes();
  if (charged_ > options_.value_memory) {
    fail_finally(at, "the strings and arrays of this scene are too large (limit " +
                         std::to_string(options_.value_memory >> 20) + " MiB)");
  }
  next_count_ = charged_ + options_.value_memory / 4;
}

}  // namespace firstlight::parser
