#pragma once

#include "render/function/function.h"
#include "render/texture/patterns.h"
#include "render/texture/pigment.h"

namespace firstlight::render {

// Patterns and pigments as functions of a point. What cannot be rendered of them gives 0, and the function tells.

/// `function { pattern { } }`: the place in the map.
FunctionPtr make_pattern_function(Patterning pattern, const PatternWorld& world);
/// `function { pigment { } }`: red, green, blue, filter, transmit.
FunctionPtr make_pigment_function(Pigment pigment, const PatternWorld& world);

}  // namespace firstlight::render
