#pragma once

#include "parser/text/scope.h"
#include "parser/text/token.h"
#include "parser/text/token_stream.h"
#include "parser/text/value.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace firstlight::parser {

class Interpreter;

/// Arrays and dictionaries: how they are written, and what brackets and keys behind a name pick of them.
class Containers {
 public:
  static constexpr std::size_t kMostElements = 1u << 24;  // in one of them
  static constexpr std::size_t kDeepest = 20;             // in each other
  using Pick = TokenStream::Pick;

  explicit Containers(Interpreter& in) : in_(in) {}

  /// The array behind the word `array`, which has been taken.
  Value parse_array();
  /// The dictionary behind `word`, which is `dictionary` and has been taken.
  Value parse_dictionary(const Token& word);
  /// `.Key` or `["Key"]`
  std::string parse_key();

  /// Where a part is in what is around it.
  struct Part {
    std::shared_ptr<Array> array;  ///< the innermost; null for a dictionary
    std::uint32_t level = 0;       ///< arrays and dictionaries around it; 0: it is none's part
  };
  /// The slot of what the brackets and keys behind `name` pick: a part, and on into it when it is a container itself.
  Scopes::Slot pick_part(const Scopes::Slot& container, const Token& name, Pick purpose);
  /// The part that was picked last.
  const Part& picked() const { return picked_; }
  /// Fails when `value` may not become that part.
  void check_part(const Part& part, const Value& value, const Location& at);

 private:
  Scopes::Slot pick_element(const std::shared_ptr<Array>& array, const Token& name, Pick purpose);
  Scopes::Slot pick_entry(const std::shared_ptr<Dictionary>& dictionary, const Token& name, Pick purpose);
  [[noreturn]] void fail_without_value(const Token& name);
  std::size_t parse_subscripts(const Array& array, const Token& name);
  void parse_initializer(Array& array, std::size_t dimension, std::size_t& element, const Token& owner);
  void parse_element(Array& array, std::size_t element);
  void grow(Array& array, std::size_t size, const Location& at);
  Scopes::Slot add_entry(Dictionary& dictionary, const std::string& key, const Location& at);
  void check_element(Array& array, const Value& value, const Location& at);
  void check_depth(std::uint32_t level, const Value& value, const Location& at);

  Interpreter& in_;
  Part picked_;
};

}  // namespace firstlight::parser
