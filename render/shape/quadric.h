#pragma once

#include "render/shape/shape.h"

namespace firstlight::render {

/// square . (x^2, y^2, z^2) + mixed . (xy, xz, yz) + linear . (x, y, z) + constant = 0; inside it is not above 0.
struct QuadricParameters {
  Vec3 square{1.0, 1.0, 1.0};
  Vec3 mixed{0.0, 0.0, 0.0};
  Vec3 linear{0.0, 0.0, 0.0};
  double constant = 1.0;
};

ShapePtr make_quadric(const QuadricParameters& parameters);

}  // namespace firstlight::render
