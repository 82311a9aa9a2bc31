#include "render/shape/plane.h"

#include "render/shape/placed.h"
#include "render/shape/primitives.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/plane.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/lane_shape-inl.h"

#ifndef FIRSTLIGHT_RENDER_SHAPE_PLANE
#define FIRSTLIGHT_RENDER_SHAPE_PLANE
namespace firstlight::render {
namespace {

/// The half of space below the plane normal . p + offset = 0.
struct HalfSpace {
  static constexpr std::size_t kSlots = 1;
  Vec3 normal;
  double offset;

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L, class Sink>
HWY_INLINE void meet(const HalfSpace& half, const RayOf<L>& ray, const Sink& met) {
  const auto normal = everywhere<L>(half.normal);
  const L approach = dot(normal, ray.direction);
  const L depth = -(dot(normal, ray.origin) + half.offset) / approach;
  met(0, depth, (abs(approach) >= kEpsilon) & (depth >= kNearestCrossing) & (depth <= kMaxDistance));
}

template <class L>
HWY_INLINE MaskOf<L> inside(const HalfSpace& half, const Vec3Of<L>& p, bool inverted) {
  const auto below = dot(p, everywhere<L>(half.normal)) + half.offset < kEpsilon;
  return inverted ? !below : below;
}

FIRSTLIGHT_MEET_KERNEL(HalfSpace)
FIRSTLIGHT_INSIDE_KERNEL(HalfSpace)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

FIRSTLIGHT_MEET_MEMBERS(HalfSpace)
FIRSTLIGHT_INSIDE_MEMBERS(HalfSpace)

/// The axis along which `normal` points exactly, or -1.
int axis_of(const Vec3& normal) {
  for (int axis = 0; axis < 3; ++axis) {
    if (normal[(axis + 1) % 3] == 0.0 && normal[(axis + 2) % 3] == 0.0) return axis;
  }
  return -1;
}

}  // namespace

void Plane::crossings(const Ray& ray, std::vector<Crossing>& out) const {
  Met met(*this, out);
  HalfSpace{normal_, offset_}.meet(ray, met);
}

bool Plane::inside(const Vec3& point) const { return HalfSpace{normal_, offset_}.inside(point, false); }

void Plane::meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only, Slots& slots) const {
  HalfSpace{normal_, offset_}.meet_block({*this, Transform(), rays, who, nearest_only}, slots);
}

std::uint64_t Plane::inside_block(const Columns3<double>& points, std::uint64_t who) const {
  return HalfSpace{normal_, offset_}.inside_block(Transform(), false, points, who);
}

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
#endif
