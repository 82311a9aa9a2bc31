#pragma once

#include "render/math/vec.h"

#include <cmath>

namespace firstlight::render {

/// The axis of the largest component; of equals the last, as POV-Ray has it.
inline int dominant_axis(const Vec3& v) {
  const double x = std::abs(v.x);
  const double y = std::abs(v.y);
  const double z = std::abs(v.z);
  if (x > y) return x > z ? 0 : 2;
  return y > z ? 1 : 2;
}

}  // namespace firstlight::render
