#pragma once

#include "render/lanes/math.h"
#include "render/math/transform.h"

#include <cmath>

namespace firstlight::render {

/// From the space in which discs, cylinders and cones are simple (around z, radius 1, height 1) to where they stand:
/// `origin` is the foot of the axis, `axis` its direction of unit length.
/// Source   POV-Ray 3.7 turns z to the axis by the shortest way; an axis within 1e-10 of +-z counts as exactly it. Every
///          rounding is kept: it decides which of two surfaces in one place is seen.
inline Transform from_canonical(const Vec3& origin, const Vec3& axis, double radius, double height) {
  Vec3 turn_axis(-axis.y, axis.x, 0.0);
  double cosine = axis.z;
  if (std::abs(axis.z) > 1.0 - 1e-10) {
    turn_axis = Vec3(1.0, 0.0, 0.0);
    cosine = axis.z < 0.0 ? -1.0 : 1.0;
  }
  return Transform::scaling(Vec3(radius, radius, height))
      .then(Transform::turning(turn_axis, steady::arc_cosine(cosine)))
      .then(Transform::translation(origin));
}

}  // namespace firstlight::render
