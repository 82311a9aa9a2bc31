#include "render/shape/box.h"

#include "render/shape/primitives.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/box.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/box-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

FIRSTLIGHT_MEET_KERNEL(AxisBox)
FIRSTLIGHT_INSIDE_KERNEL(AxisBox)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

FIRSTLIGHT_MEET_MEMBERS(AxisBox)
FIRSTLIGHT_INSIDE_MEMBERS(AxisBox)

namespace {

bool keeps_axes(const Mat4& m) {
  return m[0][1] == 0.0 && m[0][2] == 0.0 && m[1][0] == 0.0 && m[1][2] == 0.0 && m[2][0] == 0.0 && m[2][1] == 0.0;
}

AxisBox ordered(const Vec3& a, const Vec3& b) {
  AxisBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(a[axis], b[axis]);
    box.high[axis] = std::max(a[axis], b[axis]);
  }
  return box;
}

}  // namespace

void Box::crossings(const Ray& ray, std::vector<Crossing>& out) const {
  Met met(*this, out);
  box_.meet(ray, met);
}

void Box::meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only, Slots& slots) const {
  box_.meet_block({*this, Transform(), rays, who, nearest_only}, slots);
}

std::uint64_t Box::inside_block(const Columns3<double>& points, std::uint64_t who) const {
  return box_.inside_block(Transform(), inverted_, points, who);
}

Vec3 Box::normal(const Vec3& point, const Crossing& crossing) const {
  const Vec3 n = box_.normal(point, crossing);
  return inverted_ ? -n : n;
}

ShapePtr Box::placed(const Transform& transform) const {
  if (keeps_axes(transform.matrix())) {
    return std::make_shared<Box>(ordered(transform.point(box_.low), transform.point(box_.high)), inverted_);
  }
  return std::make_shared<Placed<AxisBox>>(box_, transform, inverted_);
}

ShapePtr make_box(const Vec3& corner1, const Vec3& corner2) {
  return std::make_shared<Box>(ordered(corner1, corner2), false);
}

}  // namespace firstlight::render
#endif
