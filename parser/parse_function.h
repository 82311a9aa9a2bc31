#pragma once

#include "parser/reader.h"
#include "parser/statements.h"
#include "render/function/function.h"
#include "render/function/spline.h"

#include <memory>
#include <optional>

namespace firstlight::parser {

/// The value of `function (parameters) { }`, `word` taken: an expression, a built-in function, or a pattern, pigment,
/// spline or transformation made one.
render::FunctionPtr parse_function(Reader& reader, SceneContext& context, const Token& word);

/// `{ expression }` of x, y and z (u and v are x and y), as shapes and patterns take it behind `function`.
render::FunctionPtr parse_function_block(Reader& reader, const Token& word);

/// `spline { }`, `word` taken.
std::shared_ptr<const render::Spline> parse_spline(Reader& reader, const Token& word);

/// The kind of spline that a word names.
std::optional<render::SplineKind> spline_kind(const Token& word);

/// Whether the next token is the name of a function or spline, and a call of it follows.
bool at_call(Interpreter& in);
/// The value of that call. Pre: at_call().
Numbers parse_call(Interpreter& in);

}  // namespace firstlight::parser
