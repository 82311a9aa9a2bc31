// #declare and #local, and the values that they and macro calls take.
#include "parser/directive/declarable.h"
#include "parser/directive/interpreter.h"
#include "parser/directive/reader.h"
#include "parser/expression/call.h"
#include "parser/expression/expression.h"
#include "parser/expression/string_expression.h"
#include "parser/expression/words.h"

#include <utility>

namespace firstlight::parser {

namespace {

Numbers as_numbers(const render::FilteredColor& color) {
  Numbers numbers;
  numbers.values = {color.rgb.x, color.rgb.y, color.rgb.z, color.filter, color.transmit};
  numbers.size = 5;
  numbers.is_color = true;
  return numbers;
}

// POV-Ray keeps colours, and so every declared value of five components, in single precision.
void round_color(Numbers& numbers) {
  if (numbers.size < 5) return;
  numbers.is_color = true;
  for (double& value : numbers.values) value = static_cast<float>(value);
}

}  // namespace

Interpreter::Target Interpreter::parse_target(const Token& word) {
  Target target;
  std::optional<Deprecation> deprecation;
  if (raw_next().is(Keyword::deprecated)) {
    take_raw();
    deprecation.emplace();
    deprecation->once = raw_next().is(Keyword::once);
    if (deprecation->once) take_raw();
    if (raw_next().kind == TokenKind::string) deprecation->message = unescape(*this, take_raw());
  }
  const Scopes::Reach reach = take_reach();
  target.name = take_identifier(word, reach);
  if (deprecation) {
    if (deprecation->message.empty()) deprecation->message = "'" + std::string(target.name.text) + "' is deprecated";
    deprecated_[target.name.symbol] = std::move(*deprecation);
  }
  const Scopes::Binding* binding = scopes_.find(target.name.symbol, reach);
  if (binding != nullptr && std::holds_alternative<std::shared_ptr<const Macro>>(*binding->slot)) {
    fail(target.name.location, "expected an identifier after '#" + std::string(word.text) + "', found the macro '" +
                                   std::string(target.name.text) + "'");
  }
  if (binding != nullptr && picks_part(*binding->slot, raw_next())) {
    target.slot = pick_part(Scopes::Slot(binding->slot), target.name, Pick::target);
    target.part = picked_;
    return target;
  }
  target.slot = reach == Scopes::Reach::any ? scopes_.target(target.name.symbol, word.is(Keyword::local))
                                            : scopes_.target(target.name.symbol, reach);
  return target;
}

// `Name = numbers;` for whose value there is a formula, as in most turns of loops and calls of macros. False when it is
// none; then nothing is taken.
bool Interpreter::declare_by_formula(const Token& word) {
  const Token& name = raw_next();
  if (name.kind != TokenKind::identifier || !(&name)[1].is(Punctuation::equal)) return false;
  Frame& frame = frames_.back();
  const std::uint32_t begin = frame.position;
  frame.position += 2;
  const Scopes::Binding* const binding = scopes_.find(name.symbol);
  const Formula* const formula = next_formula(Formula::Kind::sum, Punctuation::none, Punctuation::semicolon);
  if (formula != nullptr &&
      (binding == nullptr || !std::holds_alternative<std::shared_ptr<const Macro>>(*binding->slot))) {
    // The name means what is declared here from now on, even in the value.
    Value& target = *scopes_.target(name.symbol, word.is(Keyword::local));
    Numbers numbers;
    if (evaluate(*formula, 1, numbers, Punctuation::semicolon)) {
      round_color(numbers);
      target = numbers;
      return true;
    }
  }
  frame.position = begin;
  return false;
}

void Interpreter::run_declare(const Token& word, bool after_hash) {
  unsettle();
  if (declare_by_formula(word)) return;
  const Token& next = raw_next();
  if (next.is(Punctuation::left_paren) || next.is(Punctuation::less) || next.is(Punctuation::left_brace)) {
    return run_several_declare(word);
  }
  const Target target = parse_target(word);
  const Hold hold(*this);
  expect(Punctuation::equal, "after", target.name.text);
  Argument argument = parse_argument(false);
  if (argument.needs_semicolon) check_semicolon(target, word);
  store(target, std::move(argument.value));
  if (peek().is(Punctuation::semicolon) && (after_hash || argument.needs_semicolon)) {
    take();
    // A macro's value may bring a semicolon of its own.
    if (argument.needs_semicolon && peek().is(Punctuation::semicolon)) {
      take();
    } else {
      unsettle();
    }
  } else {
    unsettle();  // what follows may be the very name that has its meaning only now
  }
}

void Interpreter::check_semicolon(const Target& target, const Token& word) {
  if (peek().is(Punctuation::semicolon) || language_version() < 310) return;
  const Location& next = peek().location;
  const std::string message =
      "expected ';' after the value of '" + std::string(target.name.text) + "', found " + describe_next();
  // What is missing belongs behind the value, if that ends on a line of the same file.
  const Location end = behind_last_token();
  const Location& at = end.file == next.file ? end : next;
  if (language_version() < 350) return warn(at, message);
  SyntaxError error = error_at(at, message);
  error.diagnostics.push_back(diagnostic(word.location, render::Diagnostic::Severity::note, "the declaration is here"));
  report_mistake(error);  // and reading goes on as if it were there
}

void Interpreter::store(const Target& target, Value value) {
  charge(value, target.name.location);
  if (target.part.array) check_element(*target.part.array, value, target.name.location);
  if (target.part.level > 0) check_depth(target.part.level, value, target.name.location);
  *target.slot = std::move(value);
}

// A value as it may be declared or handed to a macro. A name alone is handed on by reference, if the macro's caller has
// it.
Interpreter::Argument Interpreter::parse_argument(bool parameter) {
  const Nesting nesting(*this);
  const std::uint32_t caller = scopes_.current();
  Argument result;
  if (const Formula* const formula = next_formula(Formula::Kind::sum);
      formula != nullptr && !(parameter && formula->is_name())) {
    Numbers numbers;
    if (evaluate(*formula, 1, numbers)) {
      round_color(numbers);
      result.value = numbers;
      result.needs_semicolon = true;
      return result;
    }
  }
  const Token* next = nullptr;
  Scopes::Binding name;
  {
    const Release release(*this);
    next = &peek();
    if (next->kind == TokenKind::identifier) {
      if (peek_value() == nullptr) {
        if (accept_word("dictionary")) {
          result.value = parse_dictionary(*next);
          return result;
        }
        fail(next->location, "expected a value, found " + describe_next());
      }
      name = peek_binding();
    }
  }
  const Token& first = *next;
  const bool by_reference = parameter && name.slot && name.scope <= caller;
  const bool called = name.slot && at_call(*this) && raw_next().is(Punctuation::left_paren);
  if (name.slot && !called && !std::holds_alternative<Numbers>(*name.slot)) {
    take_binding();
    if (by_reference) {
      result.reference = name.slot;
    } else {
      result.value = copy_of(*name.slot);
    }
    return result;
  }
  if (word_kind(first.keyword) == WordKind::color) {
    const Hold hold(*this);
    result.value = as_numbers(parse_color(*this));
    result.needs_semicolon = true;
    return result;
  }
  if (at_expression(*this)) {
    const Hold hold(*this);
    const std::uint64_t before = taken();
    Numbers numbers = parse_sum(*this, 1);
    result.needs_semicolon = true;
    if (by_reference && taken() == before + 1) {
      result.reference = name.slot;
    } else {
      round_color(numbers);
      result.value = numbers;
    }
    return result;
  }
  const Hold hold(*this);
  if (at_string(*this)) {
    result.value = parse_string(*this);
  } else if (first.is(Keyword::array)) {
    take();
    result.value = parse_array();
  } else {
    result.value = parse_statement_value();
  }
  return result;
}

Value Interpreter::parse_statement_value() {
  Reader reader(*this);
  if (std::optional<Value> value = parse_declarable(reader, context_)) return std::move(*value);
  fail(peek().location, "expected a value, found " + describe_next());
}

}  // namespace firstlight::parser
