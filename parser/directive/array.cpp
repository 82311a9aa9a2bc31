// Arrays, and what brackets behind a name pick.
#include "parser/directive/containers.h"

#include "parser/directive/interpreter.h"
#include "parser/directive/reader.h"
#include "parser/expression/expression.h"

#include <algorithm>
#include <utility>

namespace firstlight::parser {

namespace {

constexpr std::size_t kMostDimensions = 5;

}  // namespace

// Brackets and keys pick a part, and go on into it when it is an array or a dictionary itself.
Scopes::Slot Containers::pick_part(const Scopes::Slot& container, const Token& name, Pick purpose) {
  const Interpreter::Nesting nesting(in_);
  Scopes::Slot slot = container;
  picked_ = {};
  while (picks_part(*slot, in_.raw_next())) {
    const std::uint32_t level = picked_.level + 1;
    if (const auto* held = std::get_if<std::shared_ptr<Array>>(slot.get())) {
      const std::shared_ptr<Array> array = *held;
      slot = pick_element(array, name, purpose);
      picked_ = {array, level};
    } else {
      slot = pick_entry(std::shared_ptr<Dictionary>(std::get<std::shared_ptr<Dictionary>>(*slot)), name, purpose);
      picked_ = {nullptr, level};
    }
    if (purpose == Pick::value && std::holds_alternative<std::monostate>(*slot)) {
      fail_without_value(name);
    }
  }
  return slot;
}

// The mistake may be where it should have got its value.
void Containers::fail_without_value(const Token& name) {
  SyntaxError error = in_.error_at(name.location, "this element of '" + std::string(name.text) + "' has no value yet");
  error.undeclared = name.symbol;
  in_.add_call_chain(error.diagnostics);
  throw error;
}

Scopes::Slot Containers::pick_element(const std::shared_ptr<Array>& array, const Token& name, Pick purpose) {
  const std::size_t index = parse_subscripts(*array, name);
  if (index >= array->elements.size()) {  // of one that grows
    if (purpose != Pick::target) return std::make_shared<Value>();
    grow(*array, index + 1, name.location);
  }
  return Scopes::Slot(array, &array->elements[index]);
}

void Containers::grow(Array& array, std::size_t size, const Location& at) {
  if (size > kMostElements) {
    in_.fail(at, "the array is too large (limit " + std::to_string(kMostElements) + " elements)");
  }
  in_.memory().add((size - array.elements.size()) * sizeof(Value));
  array.elements.resize(size);
  array.sizes[0] = static_cast<std::uint32_t>(size);
}

std::size_t Containers::parse_subscripts(const Array& array, const Token& name) {
  std::size_t index = 0;
  for (std::size_t dimension = 0; dimension < array.sizes.size(); ++dimension) {
    in_.expect(Punctuation::left_bracket, "for each dimension of", name.text);
    const Token& at = in_.peek();
    const double subscript = parse_float(in_);
    const double size = array.grows ? static_cast<double>(kMostElements) : array.sizes[dimension];
    if (!(subscript >= -kSmallestTrue && subscript + kSmallestTrue < size)) {
      in_.fail(at.location, "expected a subscript from 0 to " + number_text(size - 1.0) + " for '" +
                                std::string(name.text) + "', found " +
                                (subscript == subscript ? number_text(subscript) : "no number"));
    }
    index = index * array.sizes[dimension] + static_cast<std::size_t>(subscript + kSmallestTrue);
    in_.expect(Punctuation::right_bracket, "behind the subscript");
  }
  return index;
}

Value Containers::parse_array() {
  auto array = std::make_shared<Array>();
  array->mixed = in_.accept_word("mixed");
  const Token& owner = in_.peek();
  std::size_t total = 1;
  while (in_.peek().is(Punctuation::left_bracket)) {
    in_.take();
    const Token& at = in_.peek();
    if (array->sizes.empty() && at.is(Punctuation::right_bracket)) {
      in_.take();
      break;
    }
    if (array->sizes.size() == kMostDimensions) {
      in_.fail(at.location, "an array has at most " + std::to_string(kMostDimensions) + " dimensions");
    }
    const double size = parse_float(in_) + kSmallestTrue;
    if (!(size >= 1.0))
      in_.fail(at.location, "expected a size of at least 1 for the array, found " + number_text(size));
    if (!(size * static_cast<double>(total) <= static_cast<double>(kMostElements))) {
      in_.fail(at.location, "the array is too large (limit " + std::to_string(kMostElements) + " elements)");
    }
    array->sizes.push_back(static_cast<std::uint32_t>(size));
    total *= array->sizes.back();
    in_.expect(Punctuation::right_bracket, "behind the size");
  }
  array->grows = array->sizes.empty();
  if (array->grows) {
    array->sizes.push_back(0);
    total = 0;
  }
  array->elements.resize(total);
  const Interpreter::Hold hold(in_);
  if (in_.peek().is(Punctuation::left_brace) || in_.next_is_word("optional")) {
    std::size_t element = 0;
    parse_initializer(*array, 0, element, owner);
  }
  return array;
}

// `{ a, b }`, and for each further dimension such lists in it. Behind `optional`, elements may be left out.
void Containers::parse_initializer(Array& array, std::size_t dimension, std::size_t& element, const Token& owner) {
  const bool optional = in_.accept_word("optional");
  Token word = owner;
  word.text = "array";
  in_.open_block(word);
  const bool inner = dimension + 1 < array.sizes.size();
  for (std::uint32_t i = 0; array.grows || i < array.sizes[dimension]; ++i) {
    if (inner) {
      parse_initializer(array, dimension + 1, element, owner);
    } else {
      const Interpreter::Release release(in_);
      const bool closed = in_.peek().is(Punctuation::right_brace);
      if (closed && array.grows) break;
      if (closed && !optional) {
        in_.fail(in_.peek().location, "expected " + std::to_string(array.sizes[dimension]) +
                                          " values for the array, found " + std::to_string(i));
      }
      if (array.grows) grow(array, element + 1, owner.location);
      if (!optional || !in_.declarations().next_is_left_out()) parse_element(array, element);
      ++element;
    }
    if (in_.peek().is(Punctuation::comma)) in_.take();
  }
  in_.close_block();
}

void Containers::parse_element(Array& array, std::size_t element) {
  const Token& at = in_.peek();
  Declarations::Argument argument = in_.declarations().parse_argument(false);
  check_element(array, argument.value, at.location);
  check_depth(1, argument.value, at.location);
  in_.memory().charge(argument.value, at.location);
  array.elements[element] = std::move(argument.value);
}

// All elements of an array are of one kind, unless it is mixed.
void Containers::check_element(Array& array, const Value& value, const Location& at) {
  if (array.mixed) return;
  if (array.kind == 0) array.kind = kind_of(value);
  if (array.kind != kind_of(value)) {
    in_.fail(at, "expected a value of the same kind as the array's other elements, found a " +
                     std::string(kind_name(value)));
  }
}

// `value` goes into an array or dictionary that has `level` - 1 others around it.
void Containers::check_depth(std::uint32_t level, const Value& value, const Location& at) {
  if (level + depth_of(value) > kDeepest) {
    in_.fail_finally(at, "arrays and dictionaries are nested too deeply here (limit " + std::to_string(kDeepest) + ")");
  }
}

void Containers::check_part(const Part& part, const Value& value, const Location& at) {
  if (part.array) check_element(*part.array, value, at);
  if (part.level > 0) check_depth(part.level, value, at);
}

}  // namespace firstlight::parser
