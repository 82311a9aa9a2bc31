#include "parser/interpreter.h"
#include "parser/reader.h"

#include <utility>

namespace firstlight::parser {

void Interpreter::define_macro(const Token& word, std::uint32_t hash) {
  const Token& name = take_identifier(word);
  const Scopes::Binding* binding = scopes_.find(name.symbol);
  if (binding != nullptr && !std::holds_alternative<std::shared_ptr<const Macro>>(*binding->slot)) {
    fail(name.location, "'" + std::string(name.text) + "' is declared already, as a " +
                            std::string(kind_name(*binding->slot)) + ", and cannot become a macro");
  }
  auto macro = std::make_shared<Macro>();
  macro->name = name.text;
  macro->file = frames_.back().file;
  const Token& opening = take_raw();
  if (!opening.is(Punctuation::left_paren)) {
    fail(opening.location, "expected '(' after the macro's name, found " + describe(opening));
  }
  while (!raw_next().is(Punctuation::right_paren)) {
    const Token* parameter = &take_raw();
    const bool optional = parameter->text == "optional" && raw_next().kind == TokenKind::identifier;
    if (optional) parameter = &take_raw();
    if (parameter->kind != TokenKind::identifier) {
      fail(parameter->location, "expected the name of a parameter or ')', found " + describe(*parameter));
    }
    macro->parameters.push_back({parameter->symbol, optional});
    if (raw_next().is(Punctuation::comma)) take_raw();
  }
  take_raw();
  macro->begin = frames_.back().position;
  macro->end = end_of_block(hash);
  *scopes_.target(name.symbol, false) = std::shared_ptr<const Macro>(std::move(macro));
  go_behind(end_of_block(hash));
}

void Interpreter::call_macro(const Token& name, const std::shared_ptr<const Macro>& macro) {
  const Nesting nesting(*this);
  count_step(name.location);
  // All arguments are read before the first parameter is bound: a macro may be its own argument.
  if (!peek().is(Punctuation::left_paren)) {
    fail(peek().location, "expected '(' to call the macro '" + std::string(name.text) + "', found " + describe_next());
  }
  take();
  std::vector<Scopes::Slot> arguments;
  arguments.reserve(macro->parameters.size());
  for (const Macro::Parameter& parameter : macro->parameters) {
    if (parameter.optional && next_is_left_out()) {
      arguments.emplace_back();
    } else {
      if (peek().is(Punctuation::right_paren)) {
        fail(peek().location, "expected " + std::to_string(macro->parameters.size()) + " arguments for the macro '" +
                                  std::string(name.text) + "', found " + std::to_string(arguments.size()));
      }
      Argument argument = parse_argument(true);
      charge(argument.value, name.location);
      arguments.push_back(argument.reference ? std::move(argument.reference)
                                             : std::make_shared<Value>(std::move(argument.value)));
    }
    if (peek().is(Punctuation::comma)) take();
  }
  expect(Punctuation::right_paren, "to close the arguments of", name.text);
  Frame frame;
  frame.file = macro->file;
  frame.position = macro->begin;
  frame.end = macro->end;
  frame.macro = macro;
  frame.call = name.location;
  enter_frame(std::move(frame));
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i]) scopes_.bind(macro->parameters[i].symbol, std::move(arguments[i]));
  }
}

}  // namespace firstlight::parser
