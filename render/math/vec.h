#pragma once

#include <ImathBox.h>
#include <ImathMatrix.h>
#include <ImathVec.h>

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

}  // namespace firstlight::render
