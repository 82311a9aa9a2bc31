#pragma once

#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#include <cmath>

namespace firstlight::render {

/// A box along the axes of its space, and its formulas. Face 2 * axis is the lower side, 2 * axis + 1 the upper.
///
/// Source   POV-Ray 3.7: of two sides met within 1e-6 of each other the one that the ray meets more squarely is it.
struct AxisBox {
  static constexpr bool kAsksBox = false;
  Vec3 low;
  Vec3 high;

  /// Depths are those of the given ray, whatever its direction's length.
  void meet(const Ray& ray, Met& met) const {
    double near = 0.0;
    double far = kBoundingHuge;
    int near_face = -1;
    int far_face = -1;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = ray.direction[axis];
      const double o = ray.origin[axis];
      if (!(std::abs(d) > kEpsilon)) {
        if (o < low[axis] || o > high[axis]) return;
        continue;
      }
      const double close = axis == 0 ? 0.0 : 1e-6;
      const bool upwards = d > 0.0;
      const double leaves = ((upwards ? high[axis] : low[axis]) - o) / d;
      const int leaving_face = 2 * axis + (upwards ? 1 : 0);
      if (leaves < near) return;
      if (leaves <= far - close) {
        far_face = leaving_face;
        far = leaves;
      } else if (leaves <= far + close && more_squarely(ray, axis, far_face)) {
        far_face = leaving_face;
      }
      const double enters = ((upwards ? low[axis] : high[axis]) - o) / d;
      const int entering_face = 2 * axis + (upwards ? 0 : 1);
      if (enters >= near + close) {
        if (enters > far) return;
        near_face = entering_face;
        near = enters;
      } else if (enters >= near - close && more_squarely(ray, axis, near_face)) {
        near_face = entering_face;
      }
    }
    if (far < kNearestCrossing || far_face < 0) return;
    if (near > kNearestCrossing) met.add(near, static_cast<std::uint32_t>(near_face));
    met.add(far, static_cast<std::uint32_t>(far_face));
  }
  bool inside(const Vec3& point, bool inverted) const { return Box3(low, high).intersects(point) != inverted; }
  Vec3 normal(const Vec3&, std::uint32_t face) const {
    Vec3 n(0.0);
    n[static_cast<int>(face / 2)] = face % 2 == 0 ? -1.0 : 1.0;
    return n;
  }
  Box3 bounds() const { return Box3(low, high); }
  Box3 inside_bounds() const { return bounds(); }

 private:
  static bool more_squarely(const Ray& ray, int axis, int face) {
    return face >= 0 && std::abs(ray.direction[axis]) > std::abs(ray.direction[face / 2]);
  }
};

/// A box along the axes of world space; what a translation or a scaling leaves a box.
class Box final : public Shape {
 public:
  Box(const AxisBox& box, bool inverted) : box_(box), inverted_(inverted) {}

  const AxisBox& axis_box() const { return box_; }

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override;
  bool inside(const Vec3& point) const override { return box_.inside(point, inverted_); }
  Vec3 normal(const Vec3& point, const Crossing& crossing) const override;
  Box3 bounds() const override { return box_.bounds(); }
  Box3 inside_bounds() const override { return inverted_ ? boundless_box() : box_.bounds(); }
  Box3 outside_bounds() const override { return inverted_ ? box_.bounds() : boundless_box(); }
  ShapePtr placed(const Transform& transform) const override;
  bool asks_box() const override { return false; }
  ShapePtr inverted() const override { return std::make_shared<Box>(box_, !inverted_); }

 private:
  AxisBox box_;
  bool inverted_;
};

}  // namespace firstlight::render
