// Arrays, and what brackets behind a name pick.
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
Scopes::Slot Interpreter::pick_part(const Scopes::Slot& container, const Token& name, Pick purpose) {
  const Nesting nesting(*this);
  Scopes::Slot slot = container;
  picked_ = {};
  while (picks_part(*slot, raw_next())) {
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
void Interpreter::fail_without_value(const Token& name) {
  SyntaxError error = error_at(name.location, "this element of '" + std::string(name.text) + "' has no value yet");
  error.undeclared = name.symbol;
  add_call_chain(error.diagnostics);
  throw error;
}

Scopes::Slot Interpreter::pick_element(const std::shared_ptr<Array>& array, const Token& name, Pick purpose) {
  const std::size_t index = parse_subscripts(*array, name);
  if (index >= array->elements.size()) {  // of one that grows
    if (purpose != Pick::target) return std::make_shared<Value>();
    grow(*array, index + 1, name.location);
  }
  return Scopes::Slot(array, &array->elements[index]);
}

void Interpreter::grow(Array& array, std::size_t size, const Location& at) {
  if (size > kMostElements) {
    fail(at, "the array is too large (limit " + std::to_string(kMostElements) + " elements)");
  }
  charged_ += (size - array.elements.size()) * sizeof(Value);
  array.elements.resize(size);
  array.sizes[0] = static_cast<std::uint32_t>(size);
}

std::size_t Interpreter::parse_subscripts(const Array& array, const Token& name) {
  std::size_t index = 0;
  for (std::size_t dimension = 0; dimension < array.sizes.size(); ++dimension) {
    expect(Punctuation::left_bracket, "for each dimension of", name.text);
    const Token& at = peek();
    const double subscript = parse_float(*this);
    const double size = array.grows ? static_cast<double>(kMostElements) : array.sizes[dimension];
    if (!(subscript >= -kSmallestTrue && subscript + kSmallestTrue < size)) {
      fail(at.location, "expected a subscript from 0 to " + number_text(size - 1.0) + " for '" +
                            std::string(name.text) + "', found " +
                            (subscript == subscript ? number_text(subscript) : "no number"));
    }
    index = index * array.sizes[dimension] + static_cast<std::size_t>(subscript + kSmallestTrue);
    expect(Punctuation::right_bracket, "behind the subscript");
  }
  return index;
}

Value Interpreter::parse_array() {
  auto array = std::make_shared<Array>();
  array->mixed = accept_word("mixed");
  const Token& owner = peek();
  std::size_t total = 1;
  while (peek().is(Punctuation::left_bracket)) {
    take();
    const Token& at = peek();
    if (array->sizes.empty() && at.is(Punctuation::right_bracket)) {
      take();
      break;
    }
    if (array->sizes.size() == kMostDimensions) {
      fail(at.location, "an array has at most " + std::to_string(kMostDimensions) + " dimensions");
    }
    const double size = parse_float(*this) + kSmallestTrue;
    if (!(size >= 1.0)) fail(at.location, "expected a size of at least 1 for the array, found " + number_text(size));
    if (!(size * static_cast<double>(total) <= static_cast<double>(kMostElements))) {
      fail(at.location, "the array is too large (limit " + std::to_string(kMostElements) + " elements)");
    }
    array->sizes.push_back(static_cast<std::uint32_t>(size));
    total *= array->sizes.back();
    expect(Punctuation::right_bracket, "behind the size");
  }
  array->grows = array->sizes.empty();
  if (array->grows) {
    array->sizes.push_back(0);
    total = 0;
  }
  array->elements.resize(total);
  const Hold hold(*this);
  if (peek().is(Punctuation::left_brace) || next_is_word("optional")) {
    std::size_t element = 0;
    parse_initializer(*array, 0, element, owner);
  }
  return array;
}

// `{ a, b }`, and for each further dimension such lists in it. Behind `optional`, elements may be left out.
void Interpreter::parse_initializer(Array& array, std::size_t dimension, std::size_t& element, const Token& owner) {
  const bool optional = accept_word("optional");
  Token word = owner;
  word.text = "array";
  open_block(word);
  const bool inner = dimension + 1 < array.sizes.size();
  for (std::uint32_t i = 0; array.grows || i < array.sizes[dimension]; ++i) {
    if (inner) {
      parse_initializer(array, dimension + 1, element, owner);
    } else {
      const Release release(*this);
      const bool closed = peek().is(Punctuation::right_brace);
      if (closed && array.grows) break;
      if (closed && !optional) {
        fail(peek().location, "expected " + std::to_string(array.sizes[dimension]) + " values for the array, found " +
                                  std::to_string(i));
      }
      if (array.grows) grow(array, element + 1, owner.location);
      if (!optional || !next_is_left_out()) parse_element(array, element);
      ++element;
    }
    if (peek().is(Punctuation::comma)) take();
  }
  close_block();
}

// Where an optional value is due: whether there is none.
bool Interpreter::next_is_left_out() {
  const Token& next = peek();
  if (next.kind == TokenKind::identifier && peek_value() == nullptr && !next_is_word("dictionary")) {
    take_binding();
    return true;
  }
  return next.is(Punctuation::comma) || next.is(Punctuation::right_brace) || next.is(Punctuation::right_paren);
}

void Interpreter::parse_element(Array& array, std::size_t element) {
  const Token& at = peek();
  Argument argument = parse_argument(false);
  check_element(array, argument.value, at.location);
  check_depth(1, argument.value, at.location);
  charge(argument.value, at.location);
  array.elements[element] = std::move(argument.value);
}

// All elements of an array are of one kind, unless it is mixed.
void Interpreter::check_element(Array& array, const Value& value, const Location& at) {
  if (array.mixed) return;
  if (array.kind == 0) array.kind = kind_of(value);
  if (array.kind != kind_of(value)) {
    fail(at,
         "expected a value of the same kind as the array's other elements, found a " + std::string(kind_name(value)));
  }
}

// `value` goes into an array or dictionary that has `level` - 1 others around it.
void Interpreter::check_depth(std::uint32_t level, const Value& value, const Location& at) {
  if (level + depth_of(value) > kDeepestArray) {
    fail_finally(at,
                 "arrays and dictionaries are nested too deeply here (limit " + std::to_string(kDeepestArray) + ")");
  }
}

}  // namespace firstlight::parser
