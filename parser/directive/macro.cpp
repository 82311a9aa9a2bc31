#include "parser/directive/interpreter.h"
#include "parser/directive/reader.h"

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

void Interpreter::call_macro(const Token& name, std::shared_ptr<const Macro> macro) {
  const Nesting nesting(*this);
  count_step(name.location);
  // All arguments are read before the first parameter is bound: a macro may be its own argument.
  expect(Punctuation::left_paren, "to call the macro", name.text);
  struct Arguments {  // those of this call, the last of all; calls among them have theirs behind
    std::vector<Scopes::Slot>& all;
    const std::size_t begin;
    ~Arguments() { all.resize(begin); }
  };
  const Arguments arguments{arguments_, arguments_.size()};
  for (const Macro::Parameter& parameter : macro->parameters) {
    if (parameter.optional && next_is_left_out()) {
      arguments_.emplace_back();
    } else {
      if (peek().is(Punctuation::right_paren)) {
        fail(peek().location, "expected " + std::to_string(macro->parameters.size()) + " arguments for the macro '" +
                                  std::string(name.text) + "', found " +
                                  std::to_string(arguments_.size() - arguments.begin));
      }
      Argument argument = parse_argument(true);
      charge(argument.value, name.location);
      arguments_.push_back(argument.reference ? std::move(argument.reference)
                                              : std::make_shared<Value>(std::move(argument.value)));
    }
    if (peek().is(Punctuation::comma)) take();
  }
  expect(Punctuation::right_paren, "to close the arguments of", name.text);
  const std::vector<Macro::Parameter>& parameters = macro->parameters;
  Frame frame;
  frame.file = macro->file;
  frame.position = macro->begin;
  frame.end = macro->end;
  frame.macro = std::move(macro);
  frame.call = name.location;
  enter_frame(std::move(frame));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    Scopes::Slot& argument = arguments_[arguments.begin + i];
    if (argument) scopes_.bind(parameters[i].symbol, std::move(argument));
  }
}

}  // namespace firstlight::parser
