// Declarations of several names at once, of the language after 3.7:
//   #declare (A, B) = (1, "two");    #declare <X, Y> = V;    #declare {First, Second} = Array;
// A name may be left out, and a value that is `optional` too.
#include "parser/directive/interpreter.h"
#include "parser/expression/expression.h"

#include <utility>

namespace firstlight::parser {

void Interpreter::run_several_declare(const Token& word) {
  const Punctuation opening = take_raw().punctuation;
  const Punctuation closing = opening == Punctuation::left_paren ? Punctuation::right_paren
                              : opening == Punctuation::less     ? Punctuation::greater
                                                                 : Punctuation::right_brace;
  const std::vector<Target> targets = parse_targets(word, closing);
  const Hold hold(*this);
  expect(Punctuation::equal, "after the names");
  if (opening == Punctuation::left_paren) {
    store_tuple(targets);
  } else if (opening == Punctuation::less) {
    store_components(targets);
  } else {
    store_elements(targets);
  }
  if (peek().is(Punctuation::semicolon)) {
    take();
  } else {
    unsettle();
  }
}

std::vector<Interpreter::Target> Interpreter::parse_targets(const Token& word, Punctuation closing) {
  std::vector<Target> targets;
  for (;;) {
    const bool optional = raw_next().text == "optional";
    if (optional) take_raw();
    if (raw_next().is(Punctuation::comma) || raw_next().is(closing)) {
      targets.push_back({.name = raw_next(), .slot = std::make_shared<Value>(), .part = {}, .optional = true});
    } else {
      targets.push_back(parse_target(word));
      targets.back().optional = optional;
      unsettle();
    }
    const Token& mark = take_raw();
    if (mark.is(closing)) return targets;
    if (!mark.is(Punctuation::comma)) {
      fail(mark.location,
           "expected ',' or '" + std::string(spelling(closing)) + "' behind the name, found " + describe(mark));
    }
  }
}

// Each value is stored before the next is read.
void Interpreter::store_tuple(const std::vector<Target>& targets) {
  {
    const Release release(*this);  // a macro may give them
    expect(Punctuation::left_paren, "before the values");
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Release release(*this);
    if (i > 0) expect(Punctuation::comma, "between the values");
    const Location at = peek().location;
    if (peek().is(Punctuation::right_paren) && !(targets[i].optional && i + 1 == targets.size())) {
      fail(at, "expected " + std::to_string(targets.size()) + " values, found " + std::to_string(i));
    }
    if (!targets[i].optional || !next_is_left_out()) store(targets[i], parse_argument(false).value);
  }
  expect(Punctuation::right_paren, "behind the values");
}

void Interpreter::store_components(const std::vector<Target>& targets) {
  const Token& at = peek();
  if (targets.size() > 5) {
    fail(at.location, "a vector has at most 5 components, but there are " + std::to_string(targets.size()) + " names");
  }
  const Numbers vector = parse_sum(*this, static_cast<std::uint8_t>(targets.size()));
  for (std::size_t i = 0; i < targets.size(); ++i) {
    Numbers number;
    number.values[0] = vector.values[i];
    store(targets[i], number);
  }
}

void Interpreter::store_elements(const std::vector<Target>& targets) {
  const Token& at = peek();
  const Value value = parse_argument(false).value;
  const auto* held = std::get_if<std::shared_ptr<Array>>(&value);
  if (held == nullptr) fail(at.location, "expected an array, found a " + std::string(kind_name(value)));
  const Array& array = **held;
  if (array.sizes.size() != 1) fail(at.location, "expected an array of one dimension");
  if (targets.size() > array.elements.size()) {
    fail(at.location, "there are " + std::to_string(targets.size()) + " names, but the array has " +
                          std::to_string(array.elements.size()) + " elements");
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (std::holds_alternative<std::monostate>(array.elements[i])) {
      fail(at.location, "element " + std::to_string(i) + " of the array has no value yet");
    }
    store(targets[i], array.elements[i]);
  }
}

}  // namespace firstlight::parser
