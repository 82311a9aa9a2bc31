#pragma once

#include "parser/token.h"
#include "render/math/program.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace firstlight::parser {

/// What is wrong with the body of a function, and where. Thrown by compile_function().
struct FunctionError {
  Location at;
  std::string message;
};

/// What words mean in the body of a function, beside the words of the language.
struct FunctionScope {
  /// Names of the parameters, in their order; they hide whatever else is called so, words of the language too.
  std::span<const std::string_view> parameters;
  /// The number that an identifier stands for; may be empty.
  std::function<std::optional<double>(const Token& identifier)> constant;
};

/// A program of an expression in the language of `function { }`: `+ - * /`, comparisons, `& | !`, parentheses, numbers
/// and the functions of one or several numbers. `tokens` end with the end of the expression.
///
/// Source   POV-Ray 3.7 manual, "User-Defined Functions"; its operators' ranks, from the weakest: `|`, `&`,
/// comparisons,
///          `+ -`, `* /`, signs; all from the left to the right.
/// Limits   nested at most 200 deep; what needs more than Program's limits is an error.
std::shared_ptr<const render::Program> compile_function(std::span<const Token> tokens, const FunctionScope& scope);

}  // namespace firstlight::parser
