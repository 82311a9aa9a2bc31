#include "render/math/block_tests.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/math/block_tests.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

std::uint64_t rays_meeting(const RayColumns& rays, const Columns3<double>& inverse, const Box3& box,
                           std::uint64_t who) {
  std::uint64_t meeting = 0;
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    const std::uint64_t of_vector = who >> i & kAllLanes;
    if (of_vector == 0) continue;
    Lanes near = 0.0;
    Lanes far = kBoundless;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const auto origin = load<Lanes>(rays.origin.of[axis], i);
      const auto inv = load<Lanes>(inverse.of[axis], i);
      const Lanes at_min = (box.min[axis] - origin) * inv;
      const Lanes at_max = (box.max[axis] - origin) * inv;
      near = max(near, min(at_min, at_max));
      far = min(far, max(at_min, at_max));
    }
    meeting |= (bits(near <= far) & of_vector) << i;
  }
  return meeting;
}

std::uint64_t points_within(const Columns3<double>& points, const Box3& box, std::uint64_t who) {
  std::uint64_t within = 0;
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    const std::uint64_t of_vector = who >> i & kAllLanes;
    if (of_vector == 0) continue;
    const auto p = load3<Lanes>(points, i);
    const auto beside = (p.x < box.min.x) | (p.x > box.max.x) | (p.y < box.min.y) | (p.y > box.max.y) |
                        (p.z < box.min.z) | (p.z > box.max.z);
    within |= (~std::uint64_t{bits(beside)} & of_vector) << i;
  }
  return within;
}

void points_of_rays(const RayColumns& rays, const Column<double>& depth, std::uint64_t who, Columns3<double>& points) {
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    if ((who >> i & kAllLanes) == 0) continue;
    store3(load3<Lanes>(rays.origin, i) + load3<Lanes>(rays.direction, i) * load<Lanes>(depth, i), points, i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(rays_meeting);
HWY_EXPORT(points_within);
HWY_EXPORT(points_of_rays);

std::uint64_t meeting(const RayColumns& rays, const Columns3<double>& inverse, const Box3& box, std::uint64_t who) {
  if (who == 0 || box.isEmpty()) return 0;
  return HWY_DYNAMIC_DISPATCH(rays_meeting)(rays, inverse, box, who);
}

std::uint64_t within(const Columns3<double>& points, const Box3& box, std::uint64_t who) {
  return HWY_DYNAMIC_DISPATCH(points_within)(points, box, who);
}

void points_along(const RayColumns& rays, const Column<double>& depth, std::uint64_t who, Columns3<double>& points) {
  HWY_DYNAMIC_DISPATCH(points_of_rays)(rays, depth, who, points);
}

}  // namespace firstlight::render
#endif
