#pragma once

#include "render/shape/shape.h"

#include <vector>

namespace firstlight::render {

/// A flat surface between closed lines, one after the other, each ending with the point that it began with. What lies
/// in an even number of them is a hole. Null: the points are not in one plane, or all on one line.
ShapePtr make_polygon(const std::vector<Vec3>& points);

}  // namespace firstlight::render
