#pragma once

#include "parser/text/syntax_error.h"
#include "parser/text/token.h"
#include "render/function/program.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace firstlight::parser {

/// A mistake in the body of a function, and its place. Thrown by compile_function().
struct FunctionError {
  Location at;
  std::string message;
  std::uint32_t unknown = kNoSymbol;  ///< the name that has no meaning, if that is the mistake
};

/// The meaning of a declared name, or of an element of an array, in the body of a function.
struct FunctionName {
  std::array<double, 5> values{};
  std::uint8_t size = 0;         ///< of a number or vector; 0: it is none
  render::FunctionPtr function;  ///< null: it is none
};

/// Meanings of words in the body of a function, beside the words of the language.
struct FunctionScope {
  /// Names of the parameters, in their order; they hide whatever else is called so, words of the language too.
  std::span<const std::string_view> parameters;
  /// For each token what its name stands for; may be empty.
  std::span<const FunctionName> names;
  /// Those of x, y, z, u and v that are no parameter are words of their own: u is x, v is y, and what is missing
  /// altogether is 0. [POV-Ray 3.7] Otherwise they are errors.
  bool has_coordinates = false;
  double clock = 0.0;
};

/// A program of an expression in the language of `function { }`: `+ - * /`, comparisons, `& | !`, parentheses, numbers
/// and the functions of one or several numbers. `tokens` end with the end of the expression.
///
/// Source   POV-Ray 3.7 manual, "User-Defined Functions"; its operators' ranks, from the weakest: `|`, `&`,
/// comparisons,
///          `+ -`, `* /`, signs; all from the left to the right. Constants that follow each other in a row of operators
///          of one rank are joined first, as POV-Ray joins them, mistakes included: x - 2*3 - 1 is x - (6 - 1).
/// Limits   nested at most 200 deep; what needs more than Program's limits is an error.
std::shared_ptr<const render::Program> compile_function(std::span<const Token> tokens, const FunctionScope& scope);

}  // namespace firstlight::parser
