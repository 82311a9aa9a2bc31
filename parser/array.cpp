#include "parser/expression.h"
#include "parser/interpreter.h"
#include "parser/reader.h"

#include <utility>

namespace firstlight::parser {

namespace {

constexpr std::size_t kMostDimensions = 5;

}  // namespace

// Several pairs of brackets pick the element of an array, and go on into it when it is an array itself.
Scopes::Slot Interpreter::pick_element(const Scopes::Slot& array, const Token& name, bool may_be_empty) {
  const Nesting nesting(*this);
  Scopes::Slot slot = array;
  while (const auto* held = std::get_if<std::shared_ptr<Array>>(slot.get())) {
    if (!raw_next().is(Punctuation::left_bracket)) break;
    const std::shared_ptr<Array> elements = *held;
    const std::size_t index = parse_subscripts(*elements, name);
    slot = Scopes::Slot(elements, &elements->elements[index]);
    if (!may_be_empty && std::holds_alternative<std::monostate>(*slot)) {
      fail(name.location, "this element of '" + std::string(name.text) + "' has no value yet");
    }
  }
  return slot;
}

std::size_t Interpreter::parse_subscripts(const Array& array, const Token& name) {
  std::size_t index = 0;
  for (const std::uint32_t size : array.sizes) {
    expect(Punctuation::left_bracket, "for each dimension of", name.text);
    const Token at = peek();
    const double subscript = parse_float(*this);
    if (!(subscript >= -kSmallestTrue && subscript + kSmallestTrue < size)) {
      fail(at.location, "expected a subscript from 0 to " + std::to_string(size - 1) + " for '" +
                            std::string(name.text) + "', found " +
                            (subscript == subscript ? number_text(subscript) : "no number"));
    }
    index = index * size + static_cast<std::size_t>(subscript + kSmallestTrue);
    expect(Punctuation::right_bracket, "behind the subscript");
  }
  return index;
}

Value Interpreter::parse_array() {
  auto array = std::make_shared<Array>();
  const Token owner = peek();
  std::size_t total = 1;
  while (peek().is(Punctuation::left_bracket)) {
    take();
    const Token at = peek();
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
  if (array->sizes.empty()) fail(owner.location, "expected '[' and a size after 'array', found " + describe_next());
  array->elements.resize(total);
  const Hold hold(*this);
  if (peek().is(Punctuation::left_brace)) {
    std::size_t element = 0;
    parse_initializer(*array, 0, element, owner);
  }
  return array;
}

void Interpreter::parse_initializer(Array& array, std::size_t dimension, std::size_t& element, const Token& owner) {
  Token word = owner;
  word.text = "array";
  open_block(word);
  for (std::uint32_t i = 0; i < array.sizes[dimension]; ++i) {
    if (dimension + 1 < array.sizes.size()) {
      parse_initializer(array, dimension + 1, element, owner);
    } else {
      const Release release(*this);
      if (peek().is(Punctuation::right_brace)) {
        fail(peek().location, "expected " + std::to_string(array.sizes[dimension]) + " values for the array, found " +
                                  std::to_string(i));
      }
      const Token at = peek();
      Argument argument = parse_argument(false);
      check_element(array, argument.value, at.location);
      array.elements[element++] = std::move(argument.value);
    }
    if (peek().is(Punctuation::comma)) take();
  }
  close_block();
}

// All elements of an array are of one kind.
void Interpreter::check_element(Array& array, const Value& value, const Location& at) {
  if (const auto* inner = std::get_if<std::shared_ptr<Array>>(&value)) {
    array.depth = std::max(array.depth, (*inner)->depth + 1);
    if (array.depth > kDeepestArray) {
      fail(at, "arrays are nested too deeply here (limit " + std::to_string(kDeepestArray) + ")");
    }
  }
  if (std::holds_alternative<std::shared_ptr<const Unsupported>>(value)) return;
  if (array.kind == 0) array.kind = kind_of(value);
  if (array.kind != kind_of(value)) {
    fail(at,
         "expected a value of the same kind as the array's other elements, found a " + std::string(kind_name(value)));
  }
}

}  // namespace firstlight::parser
