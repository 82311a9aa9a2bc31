#pragma once

#include "render/shape/shape.h"
#include "render/shape/tolerance.h"

#include <cmath>

namespace firstlight::render {

/// A half space. `normal` of unit length points out of it; the surface is normal . p + offset = 0.
class Plane final : public Shape {
 public:
  Plane(const Vec3& normal, double offset) : normal_(normal), offset_(offset) {}

  const Vec3& unit_normal() const { return normal_; }
  double offset() const { return offset_; }

  /// The depth of the one crossing, or a negative number.
  double meet(const Ray& ray) const {
    const double approach = normal_.dot(ray.direction);
    if (!(std::abs(approach) >= kEpsilon)) return -1.0;
    const double depth = -(normal_.dot(ray.origin) + offset_) / approach;
    return depth >= kNearestCrossing && depth <= kMaxDistance ? depth : -1.0;
  }

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override;
  bool inside(const Vec3& point) const override;
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
