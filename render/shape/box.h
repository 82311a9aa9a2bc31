#pragma once

#include "render/shape/placed.h"

#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// A box along the axes of its space, and its formulas. Face 2 * axis is the lower side, 2 * axis + 1 the upper.
///
/// Source   POV-Ray 3.7: of two sides met within 1e-6 of each other the one that the ray meets more squarely is it.
struct AxisBox {
  static constexpr bool kAsksBox = false;
  static constexpr std::size_t kSlots = 2;
  Vec3 low;
  Vec3 high;

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
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
};

/// A box along the axes of world space; what a translation or a scaling leaves a box.
class Box final : public Shape {
 public:
  Box(const AxisBox& box, bool inverted) : box_(box), inverted_(inverted) {}

  const AxisBox& axis_box() const { return box_; }

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override;
  bool inside(const Vec3& point) const override { return box_.inside(point, inverted_); }
  void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                  Slots& slots) const override;
  std::uint64_t inside_block(const Columns3<double>& points, std::uint64_t who) const override;
  bool is_over_lanes() const override { return true; }
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
