#pragma once

#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace firstlight::render {

/// The crossings of a box with one ray.
struct BoxMet {
  std::array<double, 2> depth;
  std::array<std::uint32_t, 2> face;
  std::size_t count = 0;

  void add(double at, std::uint32_t which) {
    depth[count] = at;
    face[count++] = which;
  }
};

/// A box along the axes of its space, and its formulas. Face 2 * axis is the lower side, 2 * axis + 1 the upper.
///
/// Source   POV-Ray 3.7: of two sides met within 1e-6 of each other the one that the ray meets more squarely is it.
struct AxisBox {
  static constexpr bool kAsksBox = false;
  Vec3 low;
  Vec3 high;

  /// Depths are those of the given ray, whatever its direction's length. `met.add(depth, face)` takes them.
  template <class List>
  void meet(const Ray& ray, List& met) const {
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
  Vec3 normal(const Vec3&, const Crossing& at) const {
    Vec3 n(0.0);
    n[static_cast<int>(at.face / 2)] = at.face % 2 == 0 ? -1.0 : 1.0;
    return n;
  }
  /// On a box that is unfolded to a cross, four squares wide and three high. [POV-Ray 3.7]
  Vec2 uv(const Vec3& point, const Crossing& at) const {
    const Vec3 size = high - low;
    const Vec3 p((point.x - low.x) / size.x, (point.y - low.y) / size.y, (point.z - low.z) / size.z);
    switch (at.face) {
      case 0:
        return Vec2(p.z / 4.0, 1.0 / 3.0 + p.y / 3.0);
      case 1:
        return Vec2(3.0 / 4.0 - p.z / 4.0, 1.0 / 3.0 + p.y / 3.0);
      case 2:
        return Vec2(1.0 / 4.0 + p.x / 4.0, p.z / 3.0);
      case 3:
        return Vec2(1.0 / 4.0 + p.x / 4.0, 1.0 - p.z / 3.0);
      case 4:
        return Vec2(1.0 - p.x / 4.0, 1.0 / 3.0 + p.y / 3.0);
      default:
        return Vec2(1.0 / 4.0 + p.x / 4.0, 1.0 / 3.0 + p.y / 3.0);
    }
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
  Vec2 uv(const Vec3& point, const Crossing& crossing) const override { return box_.uv(point, crossing); }
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
