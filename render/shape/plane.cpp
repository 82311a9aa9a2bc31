#include "render/shape/plane.h"

#include "render/shape/primitives.h"

namespace firstlight::render {
namespace {

/// The axis along which `normal` points exactly, or -1.
int axis_of(const Vec3& normal) {
  for (int axis = 0; axis < 3; ++axis) {
    if (normal[(axis + 1) % 3] == 0.0 && normal[(axis + 2) % 3] == 0.0) return axis;
  }
  return -1;
}

}  // namespace

void Plane::crossings(const Ray& ray, std::vector<Crossing>& out) const {
  const double depth = meet(ray);
  if (depth > 0.0) out.push_back({depth, this, 0, 0});
}

bool Plane::inside(const Vec3& point) const { return point.dot(normal_) + offset_ < kEpsilon; }

Vec3 Plane::normal(const Vec3&, const Crossing&) const { return normal_; }

void Plane::normals(const SurfacePlaces&, std::size_t first, std::size_t end, Columns3<double>& out) const {
  for (std::size_t i = first; i < end; ++i) out.set(i, normal_);
}

Box3 Plane::bounds() const {
  Box3 box = boundless_box();
  const int axis = axis_of(normal_);
  if (axis >= 0) box.min[axis] = box.max[axis] = -offset_ / normal_[axis];
  return box;
}

Box3 Plane::inside_bounds() const {
  Box3 box = boundless_box();
  const int axis = axis_of(normal_);
  if (axis >= 0) (normal_[axis] > 0.0 ? box.max : box.min)[axis] = -offset_ / normal_[axis];
  return box;
}

Box3 Plane::outside_bounds() const { return Plane(-normal_, -offset_).inside_bounds(); }

ShapePtr Plane::placed(const Transform& transform) const {
  const Vec3 foot = transform.point(normal_ * -offset_);
  const Vec3 n = transform.normal(normal_).normalized();
  return std::make_shared<Plane>(n, -n.dot(foot));
}

ShapePtr Plane::inverted() const { return std::make_shared<Plane>(-normal_, -offset_); }

ShapePtr make_plane(const Vec3& normal, double distance) { return std::make_shared<Plane>(unit(normal), -distance); }

}  // namespace firstlight::render
