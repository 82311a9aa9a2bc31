#include "render/shape/canonical.h"
#include "render/shape/placed.h"
#include "render/shape/primitives.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/disc.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/lane_shape-inl.h"

#include <cmath>

#ifndef FIRSTLIGHT_RENDER_SHAPE_DISC
#define FIRSTLIGHT_RENDER_SHAPE_DISC
namespace firstlight::render {
namespace {

/// Half the thickness of the box about a disc, which scenes may ask for. [POV-Ray 3.7]
constexpr double kHalfThickness = 0.001;

/// A ring around the origin in the plane z = 0. Inside is all that lies below the plane.
struct Disc {
  static constexpr std::size_t kSlots = 1;
  double hole_squared;
  double radius_squared;

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3&, const Crossing&) const { return Vec3(0.0, 0.0, 1.0); }
  Box3 bounds() const {
    const double r = std::sqrt(radius_squared);
    return Box3(Vec3(-r, -r, -kHalfThickness), Vec3(r, r, kHalfThickness));
  }
  Box3 inside_bounds() const { return boundless_box(); }
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L, class Sink>
HWY_INLINE void meet(const Disc& disc, const RayOf<L>& ray, const Sink& met) {
  const UnitRayOf<L> given = unit_ray(ray);
  const auto& [p, d] = given.ray;
  const L t = -p.z / d.z;
  const L x = p.x + t * d.x;
  const L y = p.y + t * d.y;
  const L r2 = x * x + y * y;
  const L depth = t / given.length;
  const auto ahead = (abs(d.z) > kEpsilon) & (t >= 0.0);
  const auto beside = (r2 < disc.hole_squared) | (r2 > disc.radius_squared);
  met(0, depth, without(ahead, beside) & (depth > kNearestCrossing) & (depth < kMaxDistance));
}

template <class L>
HWY_INLINE MaskOf<L> inside(const Disc&, const Vec3Of<L>& p, bool inverted) {
  const auto below = p.z < 0.0;
  return inverted ? !below : below;
}

FIRSTLIGHT_MEET_KERNEL(Disc)
FIRSTLIGHT_INSIDE_KERNEL(Disc)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

FIRSTLIGHT_MEET_MEMBERS(Disc)
FIRSTLIGHT_INSIDE_MEMBERS(Disc)

}  // namespace

ShapePtr make_disc(const Vec3& center, const Vec3& normal, double radius, double hole_radius) {
  return std::make_shared<Placed<Disc>>(Disc{hole_radius * hole_radius, radius * radius},
                                        from_canonical(center, unit(normal), 1.0, 1.0));
}

}  // namespace firstlight::render
#endif
