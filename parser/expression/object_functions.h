#pragma once

#include "parser/text/token.h"
#include "render/math/vec.h"

namespace firstlight::parser {

class Evaluator;

// Questions of expressions about declared objects, each with its word taken.

/// `trace(object, origin, direction, normal)`: where a ray first meets the object, or 0. The variable that may stand at
/// the end gets the surface's normal.
render::Vec3 parse_trace(Evaluator& in, const Token& word);
/// `inside(object, point)`
bool parse_inside(Evaluator& in, const Token& word);
/// `min_extent(object)`, `max_extent(object)`
render::Vec3 parse_extent(Evaluator& in, const Token& word);

}  // namespace firstlight::parser
