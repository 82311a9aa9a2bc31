#pragma once

#include "render/shape/shape.h"

#include <cstdint>

namespace firstlight::render {

/// Where a ray with a direction of unit length passes through a sphere.
/// Source   POV-Ray 3.7: grazing rays whose half chord squared is below 1e-10 miss.
bool meet_sphere(const Ray& ray, const Vec3& center, double radius_squared, double& enters, double& leaves);

/// Longitude and latitude of a direction from a sphere's middle, both from 0 to 1. [POV-Ray 3.7]
Vec2 sphere_uv(const Vec3& from_center);

/// A sphere that is round in world space. Anything but a similarity makes an ellipsoid of it, another class.
class Sphere final : public Shape {
 public:
  Sphere(const Vec3& center, double radius, bool inverted, const Transform& turned = Transform());

  const Vec3& center() const { return center_; }
  double radius_squared() const { return radius_ * radius_; }

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override;
  bool inside(const Vec3& point) const override;
  void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                  Slots& slots) const override;
  std::uint64_t inside_block(const Columns3<double>& points, std::uint64_t who) const override;
  bool is_over_lanes() const override { return true; }
  Vec3 normal(const Vec3& point, const Crossing& crossing) const override;
  void normals(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns3<double>& out) const override;
  Vec2 uv(const Vec3& point, const Crossing& crossing) const override;
  Box3 bounds() const override;
  Box3 given_bounds() const override;
  Box3 inside_bounds() const override;
  Box3 outside_bounds() const override;
  ShapePtr placed(const Transform& transform) const override;
  bool asks_box() const override { return false; }
  ShapePtr inverted() const override;

 private:
  Transform turned_by(const Transform& transform) const;

  Vec3 center_;
  double radius_;  ///< where it is negative, normals point inwards
  bool inverted_;
  Transform turned_;  ///< what turned its own coordinates; the identity while nothing did
};

}  // namespace firstlight::render
