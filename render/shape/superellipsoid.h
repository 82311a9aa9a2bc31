#pragma once

#include "render/shape/shape.h"

namespace firstlight::render {

/// (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1, with e = `east_west` and n = `north_south`.
ShapePtr make_superellipsoid(double east_west, double north_south);

}  // namespace firstlight::render
