// Declarations of several names at once, of the language after 3.7:
//   #declare (A, B) = (1, "two");    #declare <X, Y> = V;    #declare {First, Second} = Array;
// A name may be left out, and a value that is `optional` too.
#include "parser/directive/declarations.h"

#include "parser/directive/interpreter.h"
#include "parser/expression/expression.h"

#include <utility>

namespace firstlight::parser {

void Declarations::run_several_declare(const Token& word) {
  const Punctuation opening = in_.take_raw().punctuation;
  const Punctuation closing = opening == Punctuation::left_paren ? Punctuation::right_paren
                              : opening == Punctuation::less     ? Punctuation::greater
                                                                 : Punctuation::right_brace;
  const std::vector<Target> targets = parse_targets(word, closing);
  const Interpreter::Hold hold(in_);
  in_.expect(Punctuation::equal, "after the names");
  if (opening == Punctuation::left_paren) {
    store_tuple(targets);
  } else if (opening == Punctuation::less) {
    store_components(targets);
  } else {
    store_elements(targets);
  }
  if (in_.peek().is(Punctuation::semicolon)) {
    in_.take();
  } else {
    in_.unsettle();
  }
}

std::vector<Declarations::Target> Declarations::parse_targets(const Token& word, Punctuation closing) {
  std::vector<Target> targets;
  for (;;) {
    const bool optional = in_.raw_next().text == "optional";
    if (optional) in_.take_raw();
    if (in_.raw_next().is(Punctuation::comma) || in_.raw_next().is(closing)) {
      targets.push_back({.name = in_.raw_next(), .slot = std::make_shared<Value>(), .part = {}, .optional = true});
    } else {
      targets.push_back(parse_target(word));
      targets.back().optional = optional;
      in_.unsettle();
    }
    const Token& mark = in_.take_raw();
    if (mark.is(closing)) return targets;
    if (!mark.is(Punctuation::comma)) {
      in_.fail(mark.location,
               "expected ',' or '" + std::string(spelling(closing)) + "' behind the name, found " + describe(mark));
    }
  }
}

// Each value is stored before the next is read.
void Declarations::store_tuple(const std::vector<Target>& targets) {
  {
    const Interpreter::Release release(in_);  // a macro may give them
    in_.expect(Punctuation::left_paren, "before the values");
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Interpreter::Release release(in_);
    if (i > 0) in_.expect(Punctuation::comma, "between the values");
    const Location at = in_.peek().location;
    if (in_.peek().is(Punctuation::right_paren) && !(targets[i].optional && i + 1 == targets.size())) {
      in_.fail(at, "expected " + std::to_string(targets.size()) + " values, found " + std::to_string(i));
    }
    if (!targets[i].optional || !next_is_left_out()) store(targets[i], parse_argument(false).value);
  }
  in_.expect(Punctuation::right_paren, "behind the values");
}

void Declarations::store_components(const std::vector<Target>& targets) {
  const Token& at = in_.peek();
  if (targets.size() > 5) {
    in_.fail(at.location,
             "a vector has at most 5 components, but there are " + std::to_string(targets.size()) + " names");
  }
  const Numbers vector = parse_sum(in_, static_cast<std::uint8_t>(targets.size()));
  for (std::size_t i = 0; i < targets.size(); ++i) {
    Numbers number;
    number.values[0] = vector.values[i];
    store(targets[i], number);
  }
}

void Declarations::store_elements(const std::vector<Target>& targets) {
  const Token& at = in_.peek();
  const Value value = parse_argument(false).value;
  const auto* held = std::get_if<std::shared_ptr<Array>>(&value);
  if (held == nullptr) in_.fail(at.location, "expected an array, found a " + std::string(kind_name(value)));
  const Array& array = **held;
  if (array.sizes.size() != 1) in_.fail(at.location, "expected an array of one dimension");
  if (targets.size() > array.elements.size()) {
    in_.fail(at.location, "there are " + std::to_string(targets.size()) + " names, but the array has " +
                              std::to_string(array.elements.size()) + " elements");
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (std::holds_alternative<std::monostate>(array.elements[i])) {
      in_.fail(at.location, "element " + std::to_string(i) + " of the array has no value yet");
    }
    store(targets[i], array.elements[i]);
  }
}

}  // namespace firstlight::parser
