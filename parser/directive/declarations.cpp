// #declare and #local, and the values that they and macro calls take.
#include "parser/directive/declarations.h"

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

Declarations::Target Declarations::parse_target(const Token& word) {
  Target target;
  std::optional<TokenStream::Deprecation> deprecation;
  if (in_.raw_next().is(Keyword::deprecated)) {
    in_.take_raw();
    deprecation.emplace();
    deprecation->once = in_.raw_next().is(Keyword::once);
    if (deprecation->once) in_.take_raw();
    if (in_.raw_next().kind == TokenKind::string) deprecation->message = unescape(in_, in_.take_raw());
  }
  const Scopes::Reach reach = in_.take_reach();
  target.name = in_.take_identifier(word, reach);
  if (deprecation) {
    if (deprecation->message.empty()) deprecation->message = "'" + std::string(target.name.text) + "' is deprecated";
    in_.deprecate(target.name.symbol, std::move(*deprecation));
  }
  const Scopes::Binding* binding = in_.scopes().find(target.name.symbol, reach);
  if (binding != nullptr && std::holds_alternative<std::shared_ptr<const Macro>>(*binding->slot)) {
    in_.fail(target.name.location, "expected an identifier after '#" + std::string(word.text) + "', found the macro '" +
                                       std::string(target.name.text) + "'");
  }
  if (binding != nullptr && picks_part(*binding->slot, in_.raw_next())) {
    target.slot = in_.containers().pick_part(Scopes::Slot(binding->slot), target.name, TokenStream::Pick::target);
    target.part = in_.containers().picked();
    return target;
  }
  target.slot = reach == Scopes::Reach::any ? in_.scopes().target(target.name.symbol, word.is(Keyword::local))
                                            : in_.scopes().target(target.name.symbol, reach);
  return target;
}

// `Name = numbers;` for whose value there is a formula, as in most turns of loops and calls of macros. False when it is
// none; then nothing is taken.
bool Declarations::declare_by_formula(const Token& word) {
  Interpreter::Frame& frame = in_.frame();
  const std::uint32_t begin = frame.position;
  const Token& name = frame.file->view(begin);
  if (name.kind != TokenKind::identifier) return false;
  const std::uint32_t symbol = name.symbol;
  if (!frame.file->view(begin + 1).is(Punctuation::equal)) return false;
  frame.position += 2;
  const Scopes::Binding* const binding = in_.scopes().find(symbol);
  const Formula* const formula = in_.next_formula(Formula::Kind::sum, Punctuation::none, Punctuation::semicolon);
  if (formula != nullptr &&
      (binding == nullptr || !std::holds_alternative<std::shared_ptr<const Macro>>(*binding->slot))) {
    // The name means what is declared here from now on, even in the value.
    Value& target = *in_.scopes().target(symbol, word.is(Keyword::local));
    Numbers numbers;
    if (in_.evaluate(*formula, 1, numbers, Punctuation::semicolon)) {
      round_color(numbers);
      target = numbers;
      return true;
    }
  }
  frame.position = begin;
  return false;
}

void Declarations::run_declare(const Token& word, bool after_hash) {
  in_.unsettle();
  if (declare_by_formula(word)) return;
  const Token& next = in_.raw_next();
  if (next.is(Punctuation::left_paren) || next.is(Punctuation::less) || next.is(Punctuation::left_brace)) {
    return run_several_declare(word);
  }
  const Target target = parse_target(word);
  const Interpreter::Hold hold(in_);
  in_.expect(Punctuation::equal, "after", target.name.text);
  Argument argument = parse_argument(false);
  if (argument.needs_semicolon) check_semicolon(target, word);
  store(target, std::move(argument.value));
  if (in_.peek().is(Punctuation::semicolon) && (after_hash || argument.needs_semicolon)) {
    in_.take();
    // A macro's value may bring a semicolon of its own.
    if (argument.needs_semicolon && in_.peek().is(Punctuation::semicolon)) {
      in_.take();
    } else {
      in_.unsettle();
    }
  } else {
    in_.unsettle();  // what follows may be the very name that has its meaning only now
  }
}

void Declarations::check_semicolon(const Target& target, const Token& word) {
  if (in_.peek().is(Punctuation::semicolon) || in_.language_version() < 310) return;
  const Location& next = in_.peek().location;
  const std::string message =
      "expected ';' after the value of '" + std::string(target.name.text) + "', found " + in_.describe_next();
  // The missing semicolon belongs behind the value, if that ends on a line of the same file.
  const Location end = in_.behind_last_token();
  const Location& at = end.file == next.file ? end : next;
  if (in_.language_version() < 350) return in_.warn(at, message);
  SyntaxError error = in_.error_at(at, message);
  error.diagnostics.push_back(
      in_.diagnostic(word.location, render::Diagnostic::Severity::note, "the declaration is here"));
  in_.recovery().report(error);  // and reading goes on as if it were there
}

void Declarations::store(const Target& target, Value value) {
  in_.memory().charge(value, target.name.location);
  in_.containers().check_part(target.part, value, target.name.location);
  *target.slot = std::move(value);
}

// A value as it may be declared or handed to a macro. A name alone is handed on by reference, if the macro's caller has
// it.
Declarations::Argument Declarations::parse_argument(bool parameter) {
  const Interpreter::Nesting nesting(in_);
  const std::uint32_t caller = in_.scopes().current();
  Argument result;
  if (const Formula* const formula = in_.next_formula(Formula::Kind::sum);
      formula != nullptr && !(parameter && formula->is_name())) {
    Numbers numbers;
    if (in_.evaluate(*formula, 1, numbers)) {
      round_color(numbers);
      result.value = numbers;
      result.needs_semicolon = true;
      return result;
    }
  }
  Token first;
  Scopes::Binding name;
  {
    const Interpreter::Release release(in_);
    first = in_.peek();
    if (first.kind == TokenKind::identifier) {
      if (in_.peek_value() == nullptr) {
        if (in_.accept_word("dictionary")) {
          result.value = in_.containers().parse_dictionary(first);
          return result;
        }
        in_.fail(first.location, "expected a value, found " + in_.describe_next());
      }
      name = in_.peek_binding();
    }
  }
  const bool by_reference = parameter && name.slot && name.scope <= caller;
  const bool called = name.slot && at_call(in_) && in_.raw_next().is(Punctuation::left_paren);
  if (name.slot && !called && !std::holds_alternative<Numbers>(*name.slot)) {
    in_.take_binding();
    if (by_reference) {
      result.reference = name.slot;
    } else {
      result.value = copy_of(*name.slot);
    }
    return result;
  }
  if (word_kind(first.keyword) == WordKind::color) {
    const Interpreter::Hold hold(in_);
    result.value = as_numbers(parse_color(in_));
    result.needs_semicolon = true;
    return result;
  }
  if (at_expression(in_)) {
    const Interpreter::Hold hold(in_);
    const std::uint64_t before = in_.taken();
    Numbers numbers = parse_sum(in_, 1);
    result.needs_semicolon = true;
    if (by_reference && in_.taken() == before + 1) {
      result.reference = name.slot;
    } else {
      round_color(numbers);
      result.value = numbers;
    }
    return result;
  }
  const Interpreter::Hold hold(in_);
  if (at_string(in_)) {
    result.value = parse_string(in_);
  } else if (first.is(Keyword::array)) {
    in_.take();
    result.value = in_.containers().parse_array();
  } else {
    Reader reader(in_);
    std::optional<Value> value = parse_declarable(reader, in_.context());
    if (!value) in_.fail(in_.peek().location, "expected a value, found " + in_.describe_next());
    result.value = std::move(*value);
  }
  return result;
}

// Where an optional value is due: whether there is none.
bool Declarations::next_is_left_out() {
  const Token& next = in_.peek();
  if (next.kind == TokenKind::identifier && in_.peek_value() == nullptr && !in_.next_is_word("dictionary")) {
    in_.take_binding();
    return true;
  }
  return next.is(Punctuation::comma) || next.is(Punctuation::right_brace) || next.is(Punctuation::right_paren);
}

}  // namespace firstlight::parser
