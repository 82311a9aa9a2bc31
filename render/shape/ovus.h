#pragma once

#include "render/shape/shape.h"

namespace firstlight::render {

/// An egg around the y axis: a ball of `bottom_radius` at the origin, one of `top_radius` that lies bottom_radius higher,
/// and a part of a torus that joins them smoothly. Pre: neither is negative; top_radius < 2 * bottom_radius.
/// [POV-Ray 3.7 manual, "Ovus"]
ShapePtr make_ovus(double bottom_radius, double top_radius);

}  // namespace firstlight::render
