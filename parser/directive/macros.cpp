#include "parser/directive/macros.h"

#include "parser/directive/interpreter.h"
#include "parser/directive/reader.h"

#include <utility>

namespace firstlight::parser {

void Macros::define(const Token& word, std::uint32_t hash) {
  const Token& name = in_.take_identifier(word);
  const Scopes::Binding* binding = in_.scopes().find(name.symbol);
  if (binding != nullptr && !std::holds_alternative<std::shared_ptr<const Macro>>(*binding->slot)) {
    in_.fail(name.location, "'" + std::string(name.text) + "' is declared already, as a " +
                                std::string(kind_name(*binding->slot)) + ", and cannot become a macro");
  }
  auto macro = std::make_shared<Macro>();
  macro->name = name.text;
  macro->file = in_.frame().file;
  const Token& opening = in_.take_raw();
  if (!opening.is(Punctuation::left_paren)) {
    in_.fail(opening.location, "expected '(' after the macro's name, found " + describe(opening));
  }
  while (!in_.raw_next().is(Punctuation::right_paren)) {
    Token parameter = in_.take_raw();
    const bool optional = parameter.text == "optional" && in_.raw_next().kind == TokenKind::identifier;
    if (optional) parameter = in_.take_raw();
    if (parameter.kind != TokenKind::identifier) {
      in_.fail(parameter.location, "expected the name of a parameter or ')', found " + describe(parameter));
    }
    macro->parameters.push_back({parameter.symbol, optional});
    if (in_.raw_next().is(Punctuation::comma)) in_.take_raw();
  }
  in_.take_raw();
  macro->begin = in_.frame().position;
  macro->end = end_of_block(*macro->file, hash);
  in_.go_behind(macro->end);
  *in_.scopes().target(name.symbol, false) = std::shared_ptr<const Macro>(std::move(macro));
}

void Macros::call(const Token& name, std::shared_ptr<const Macro> macro) {
  const Interpreter::Nesting nesting(in_);
  in_.count_step(name.location);
  // All arguments are read before the first parameter is bound: a macro may be its own argument.
  in_.expect(Punctuation::left_paren, "to call the macro", name.text);
  struct Arguments {  // those of this call, the last of all; calls among them have theirs behind
    std::vector<Scopes::Slot>& all;
    const std::size_t begin;
    ~Arguments() { all.resize(begin); }
  };
  const Arguments arguments{arguments_, arguments_.size()};
  for (const Macro::Parameter& parameter : macro->parameters) {
    if (parameter.optional && in_.declarations().next_is_left_out()) {
      arguments_.emplace_back();
    } else {
      if (in_.peek().is(Punctuation::right_paren)) {
        in_.fail(in_.peek().location, "expected " + std::to_string(macro->parameters.size()) +
                                          " arguments for the macro '" + std::string(name.text) + "', found " +
                                          std::to_string(arguments_.size() - arguments.begin));
      }
      Declarations::Argument argument = in_.declarations().parse_argument(true);
      in_.memory().charge(argument.value, name.location);
      arguments_.push_back(argument.reference ? std::move(argument.reference)
                                              : std::make_shared<Value>(std::move(argument.value)));
    }
    if (in_.peek().is(Punctuation::comma)) in_.take();
  }
  in_.expect(Punctuation::right_paren, "to close the arguments of", name.text);
  const std::vector<Macro::Parameter>& parameters = macro->parameters;
  Interpreter::Frame frame;
  frame.file = macro->file;
  frame.position = macro->begin;
  frame.end = macro->end;
  frame.macro = std::move(macro);
  frame.call = name.location;
  in_.enter_frame(std::move(frame));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    Scopes::Slot& argument = arguments_[arguments.begin + i];
    if (argument) in_.scopes().bind(parameters[i].symbol, std::move(argument));
  }
}

}  // namespace firstlight::parser
