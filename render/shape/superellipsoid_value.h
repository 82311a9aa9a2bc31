#pragma once

#include "render/math/vec.h"

#include <array>
#include <cstddef>

namespace firstlight::render {

/// ((|x|^around + |y|^around)^(along / around) + |z|^along)^(1 / along) - 1: less than 0 inside of a superellipsoid.
/// Source   POV-Ray 3.7's reference manual, "Superquadric Ellipsoid".
struct SuperellipsoidValue {
  double around;  ///< 2 / e
  double along;   ///< 2 / n

  double at(const Vec3& point) const;
  /// The values at several depths of a ray, side by side; those behind the first `count` mean nothing. The same bits as
  /// one by one.
  using Several = std::array<double, 24>;
  Several at(const Ray& ray, const Several& depths, std::size_t count) const;
};

}  // namespace firstlight::render
