#pragma once

#include "render/shape/shape.h"

#include <cstdint>

namespace firstlight::render {

/// A half space. `normal` of unit length points out of it; the surface is normal . p + offset = 0.
class Plane final : public Shape {
 public:
  Plane(const Vec3& normal, double offset) : normal_(normal), offset_(offset) {}

  const Vec3& unit_normal() const { return normal_; }
  double offset() const { return offset_; }

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override;
  bool inside(const Vec3& point) const override;
  void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                  Slots& slots) const override;
  std::uint64_t inside_block(const Columns3<double>& points, std::uint64_t who) const override;
  bool is_over_lanes() const override { return true; }
  Vec3 normal(const Vec3& point, const Crossing& crossing) const override;
  void normals(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns3<double>& out) const override;
  Box3 bounds() const override;
  Box3 inside_bounds() const override;
  Box3 outside_bounds() const override;
  ShapePtr placed(const Transform& transform) const override;
  bool asks_box() const override { return false; }
  ShapePtr inverted() const override;

 private:
  Vec3 normal_;
  double offset_;
};

}  // namespace firstlight::render
