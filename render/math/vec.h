#pragma once

#include <ImathBox.h>
#include <ImathMatrix.h>
#include <ImathVec.h>

#include <cmath>

namespace firstlight::render {

using Vec2 = Imath::V2d;
using Vec3 = Imath::V3d;
using Vec4 = Imath::V4d;
using Mat4 = Imath::M44d;
/// Axis-aligned box. Default constructed it is empty; an unbounded shape has an infinite one (makeInfinite()).
using Box3 = Imath::Box3d;

/// A half line. `direction` is of unit length in world space, so a depth along it is a distance in scene units;
/// inside a transformed shape it may have any length (depths stay the same).
struct Ray {
  Vec3 origin;
  Vec3 direction;

  Vec3 at(double depth) const { return origin + direction * depth; }
};

/// `v` at unit length; zero stays zero. It is multiplied by the reciprocal, as in POV-Ray: the last bit of a ray or a
/// normal decides between two surfaces in one place.
inline Vec3 unit(const Vec3& v) {
  const double length = std::sqrt(v.dot(v));
  return length > 0.0 ? v * (1.0 / length) : v;
}

}  // namespace firstlight::render
