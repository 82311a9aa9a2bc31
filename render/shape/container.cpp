#include "render/shape/container.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/container.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/box-inl.h"
#include "render/shape/lane_shape-inl.h"
#include "render/shape/through_sphere-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Takes where rays meet a box.
struct BoxPartSink {
  ContainedRays& contained;
  std::size_t at;
  std::uint64_t of_vector;

  HWY_INLINE void operator()(std::size_t k, const Lanes& depth, const LanesMask& met, const Lanes& face) const {
    if (k == 0) {
      store(select(met, depth, 0.0), contained.begin, at);
      store(select(met, 1.0 + face, 0.0), contained.begin_face, at);
    } else {
      store(depth, contained.end, at);
      store(1.0 + face, contained.end_face, at);
      contained.met |= (bits(met) & of_vector) << at;
    }
  }
};

void contain_rays(const Container& container, const Transform& transform, const RayColumns& given, std::uint64_t who,
                  ContainedRays& contained) {
  const auto* sphere = std::get_if<ContainerSphere>(&container);
  const auto* box = std::get_if<ContainerBox>(&container);
  for_each_vector(transform, given, who, [&](const RayOf<Lanes>& ray, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
    store3(ray.origin, contained.rays.origin, i);
    store3(ray.direction, contained.rays.direction, i);
    if (sphere == nullptr) return meet(AxisBox{box->low, box->high}, ray, BoxPartSink{contained, i, of_vector});
    const UnitRayOf<Lanes> unit = unit_ray(ray);
    const auto through = through_sphere(unit.ray, sphere->center, sphere->radius * sphere->radius);
    store(through.enters / unit.length, contained.begin, i);
    store(through.leaves / unit.length, contained.end, i);
    store(Lanes(0.0), contained.begin_face, i);
    store(Lanes(0.0), contained.end_face, i);
    contained.met |= (bits(through.met) & of_vector) << i;
  });
}

std::uint64_t hold_points(const Container& container, const Transform& transform, const Columns3<double>& points,
                          std::uint64_t who, Columns3<double>& own) {
  const auto* sphere = std::get_if<ContainerSphere>(&container);
  const auto* box = std::get_if<ContainerBox>(&container);
  std::uint64_t held = 0;
  for_each_vector(transform, points, who, [&](const Vec3Of<Lanes>& p, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
    store3(p, own, i);
    LanesMask is_in;
    if (sphere == nullptr) {
      is_in = inside(AxisBox{box->low, box->high}, p, false);
    } else {
      const Vec3Of<Lanes> to_center = everywhere<Lanes>(sphere->center) - p;
      is_in = dot(to_center, to_center) <= sphere->radius * sphere->radius;
    }
    held |= (bits(is_in) & of_vector) << i;
  });
  return held;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(contain_rays);
HWY_EXPORT(hold_points);

ContainedRays::ContainedRays(const Container& container, const Transform& transform, const RayColumns& given,
                             std::uint64_t who) {
  HWY_DYNAMIC_DISPATCH(contain_rays)(container, transform, given, who, *this);
}

std::uint64_t held_points(const Container& container, const Transform& transform, const Columns3<double>& points,
                          std::uint64_t who, Columns3<double>& own) {
  return HWY_DYNAMIC_DISPATCH(hold_points)(container, transform, points, who, own);
}

}  // namespace firstlight::render
#endif
