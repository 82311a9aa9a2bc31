#pragma once

#include "render/math/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace firstlight::render {

/// The coordinate at which a box reaches without end; what Imath's makeInfinite() uses.
constexpr double kBoundless = std::numeric_limits<double>::max();

inline Box3 boundless_box() { return Box3(Vec3(-kBoundless), Vec3(kBoundless)); }

/// Whether every face is at a finite place.
inline bool is_bounded(const Box3& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.min[axis] > -kBoundless && box.max[axis] < kBoundless)) return false;
  }
  return true;
}

inline Box3 overlap(const Box3& a, const Box3& b) {
  Box3 both;
  for (int axis = 0; axis < 3; ++axis) {
    both.min[axis] = std::max(a.min[axis], b.min[axis]);
    both.max[axis] = std::min(a.max[axis], b.max[axis]);
  }
  return both.isEmpty() ? Box3() : both;
}

/// The box with room for rounding: each finite face moves out by `relative` of the box's largest coordinate, and by
/// `least` if that is more, so even a flat box at 0 gets thickness and a computed point on its surface lies within.
inline Box3 padded(const Box3& box, double relative, double least) {
  if (box.isEmpty()) return box;
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double face : {box.min[axis], box.max[axis]}) {
      if (std::abs(face) < kBoundless) largest = std::max(largest, std::abs(face));
    }
  }
  const double room = std::max(largest * relative, least);
  Box3 out = box;
  for (int axis = 0; axis < 3; ++axis) {
    if (out.min[axis] > -kBoundless) out.min[axis] -= room;
    if (out.max[axis] < kBoundless) out.max[axis] += room;
  }
  return out;
}

/// Whether `ray` passes through `box` in front of its origin. Rounding never makes it miss a box that it meets by more
/// than a few units in the last place, so test padded boxes.
inline bool meets(const Ray& ray, const Box3& box) {
  if (box.isEmpty()) return false;
  double near = 0.0;
  double far = kBoundless;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    const double o = ray.origin[axis];
    if (d == 0.0) {
      if (o < box.min[axis] || o > box.max[axis]) return false;
      continue;
    }
    const double inverse = 1.0 / d;
    const double t1 = (box.min[axis] - o) * inverse;
    const double t2 = (box.max[axis] - o) * inverse;
    near = std::max(near, std::min(t1, t2));
    far = std::min(far, std::max(t1, t2));
  }
  return near <= far;
}

}  // namespace firstlight::render
