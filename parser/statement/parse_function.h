#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/statements.h"
#include "render/function/function.h"
#include "render/function/spline.h"

#include <memory>

namespace firstlight::parser {

/// The value of `function (parameters) { }`, `word` taken: an expression, a built-in function, or a pattern, pigment,
/// spline or transformation made one.
render::FunctionPtr parse_function(Reader& reader, SceneContext& context, const Token& word);

/// `{ expression }` of x, y and z (u and v are x and y), as shapes and patterns take it behind `function`.
render::FunctionPtr parse_function_block(Reader& reader, const Token& word);

/// `spline { }`, `word` taken.
std::shared_ptr<const render::Spline> parse_spline(Reader& reader, const Token& word);

}  // namespace firstlight::parser
