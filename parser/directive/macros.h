#pragma once

#include "parser/text/scope.h"
#include "parser/text/token.h"
#include "parser/text/value.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace firstlight::parser {

class Interpreter;

/// `#macro`, and calls of macros: their text is read again, with the parameters bound.
class Macros {
 public:
  explicit Macros(Interpreter& in) : in_(in) {}

  /// `#macro`, its `#` at `hash`.
  void define(const Token& word, std::uint32_t hash);
  /// At the macro's name, which has been passed: enters the macro's text.
  void call(const Token& name, std::shared_ptr<const Macro> macro);

 private:
  Interpreter& in_;
  std::vector<Scopes::Slot> arguments_;  // of the macros whose arguments are being read
};

}  // namespace firstlight::parser
