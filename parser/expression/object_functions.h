#pragma once

#include "parser/text/token.h"
#include "parser/text/value.h"

namespace firstlight::parser {

class Evaluator;

// Questions of expressions about declared objects, each with its word taken.

/// `trace(object, origin, direction, normal)`: where a ray first meets the object, or 0. The variable that may stand at
/// the end gets the surface's normal.
Numbers parse_trace(Evaluator& in, const Token& word);
/// `inside(object, point)`
Numbers parse_inside(Evaluator& in, const Token& word);
/// `min_extent(object)`, `max_extent(object)`
Numbers parse_extent(Evaluator& in, const Token& word);

}  // namespace firstlight::parser
