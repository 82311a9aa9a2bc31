#include "render/shape/ovus.h"

#include "render/shape/placed.h"
#include "render/shape/sphere.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/ovus.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/depth_roots-inl.h"
#include "render/shape/through_sphere-inl.h"

#include <algorithm>
#include <array>
#include <cmath>

#ifndef FIRSTLIGHT_RENDER_SHAPE_OVUS
#define FIRSTLIGHT_RENDER_SHAPE_OVUS
namespace firstlight::render {
namespace {

/// POV-Ray's for this shape: how far from the tube a root may be, as a difference of squares.
constexpr double kRootRoom = 1e-4;

enum Face : std::uint32_t { kBottom, kTop, kSide };

struct Ovus {
  double bottom;  ///< radii
  double top;
  double tube;  ///< of the torus that joins the balls
  double ring;  ///< of its circle, on whose far side of the axis the surface lies
  double ring_height;
  double bottom_ends;  ///< the height where the lower ball ends
  double top_begins;

  Ovus(double bottom_radius, double top_radius) : bottom(bottom_radius), top(top_radius) {
    if (bottom > top) {
      tube = 2.0 * bottom;
      ring_height = 2.0 * top - bottom - top * top / (2.0 * bottom);
      ring = std::sqrt(std::max(0.0, bottom * bottom - ring_height * ring_height));
      bottom_ends = -ring_height;
      top_begins = (bottom - ring_height) * top / (tube - top) + bottom;
    } else {
      tube = 2.0 * top;
      ring_height = -2.0 * top + bottom + 1.5 * top * top / bottom;
      ring = std::sqrt(std::max(0.0, top * top - (ring_height - bottom) * (ring_height - bottom)));
      top_begins = 2.0 * bottom - ring_height;
      bottom_ends = -ring_height * bottom / (tube - bottom);
    }
  }

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    if (at.face == kBottom) return p;
    if (at.face == kTop) return p - Vec3(0.0, bottom, 0.0);
    const double from_axis = std::sqrt(p.x * p.x + p.z * p.z);
    if (!(from_axis > 0.0)) return Vec3(0.0, p.y - ring_height, 0.0);
    const double out = 1.0 + ring / from_axis;
    return Vec3(p.x * out, p.y - ring_height, p.z * out);
  }
  Vec2 uv(const Vec3& p, const Crossing&) const { return sphere_uv(p - Vec3(0.0, 0.5 * top, 0.0)); }
  Box3 bounds() const {
    const double widest = std::max({tube - ring, bottom, top});
    return Box3(Vec3(-widest, -bottom, -widest), Vec3(widest, bottom + top, widest));
  }
  Box3 inside_bounds() const { return bounds(); }
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// met(k, depth, mask, face) for the two balls, as render/shape/lane_shape-inl.h says.
template <class L, class Sink>
HWY_INLINE void meet_balls(const Ovus& ovus, const UnitRayOf<L>& unit, const Sink& met) {
  const auto meet_ball = [&](std::size_t first, const Vec3& center, double radius, std::uint32_t face,
                             const auto& is_seen) HWY_ATTR {
    const ThroughSphere<L> through = through_sphere(unit.ray, center, radius * radius);
    const auto add = [&](std::size_t k, const L& depth) HWY_ATTR {
      const L height = unit.ray.origin.y + depth * unit.ray.direction.y;
      met(k, depth / unit.length, through.met & is_seen(height) & (depth > kEpsilon), face);
    };
    add(first, through.enters);
    add(first + 1, through.leaves);
  };
  meet_ball(0, Vec3(0.0), ovus.bottom, kBottom, [&](const L& height) HWY_ATTR { return height < ovus.bottom_ends; });
  meet_ball(2, Vec3(0.0, ovus.bottom, 0.0), ovus.top, kTop,
            [&](const L& height) HWY_ATTR { return height > ovus.top_begins; });
}

template <class L>
HWY_INLINE L from_ring_squared(const Ovus& ovus, const Vec3Of<L>& p) {
  const L across = sqrt(p.x * p.x + p.z * p.z) + ovus.ring;
  const L up = p.y - ovus.ring_height;
  return across * across + up * up;
}

/// The torus whose inner sheet lies between the balls. Depths are counted from the point nearest to the ring's middle:
/// there the coefficients keep their digits.
template <class L>
HWY_INLINE DepthEquation<L, 4> equation_along(const Ovus& ovus, const UnitRayOf<L>& unit) {
  const Vec3Of<L>& d = unit.ray.direction;
  const Vec3Of<L> from_middle = unit.ray.origin - everywhere<L>(Vec3(0.0, ovus.ring_height, 0.0));
  const L skipped = -dot(from_middle, d);
  const Vec3Of<L> p = from_middle + d * skipped;
  const double reach = ovus.ring + ovus.tube;
  const L distance_squared = dot(p, p);
  const L half = sqrt(reach * reach - distance_squared);  // no number where the ray passes outside
  const double ring2 = ovus.ring * ovus.ring;
  const double tube2 = ovus.tube * ovus.tube;
  const L k1 = distance_squared - ring2 - tube2;
  const L k2 = dot(p, d);
  return {{k1 * k1 + 4.0 * ring2 * (p.y * p.y - tube2), 4.0 * (k1 * k2 + 2.0 * ring2 * p.y * d.y),
           2.0 * k1 + 4.0 * k2 * k2 + 4.0 * ring2 * d.y * d.y, 4.0 * k2, L(1.0)},
          -half,
          half,
          skipped,
          unit.length};
}

/// Whether a root, at a depth along the unit ray, lies on the side.
inline bool is_on_side(const Ovus& ovus, const Ray& ray, double depth) {
  const Vec3 point = ray.at(depth);
  if (!(depth > kEpsilon && point.y > ovus.bottom_ends && point.y < ovus.top_begins)) return false;
  return std::abs(from_ring_squared(ovus, everywhere<One>(point)).v - ovus.tube * ovus.tube) < kRootRoom;
}

void meet_ovus(const Ovus& ovus, const RaysAndPlace& asked, Slots& slots) {
  RayColumns rays;
  Column<double> skipped;
  Column<double> length;
  SlotLists lists(asked.shape, slots, true);
  RootJobs jobs([&](std::size_t i, std::uint32_t face, double t) {
    const double depth = t + skipped[i];
    if (is_on_side(ovus, rays.ray(i), depth)) lists.add(i, depth / length[i], face, {});
  });
  for_each_vector(asked, [&](const RayOf<Lanes>& given, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
    const UnitRayOf<Lanes> unit = unit_ray(given);
    store3(unit.ray.origin, rays.origin, i);
    store3(unit.ray.direction, rays.direction, i);
    meet_balls(ovus, unit, SlotListSink{lists, i, of_vector});
    const DepthEquation<Lanes, 4> equation = equation_along(ovus, unit);
    store(equation.skipped, skipped, i);
    store(equation.length, length, i);
    add_jobs(jobs, i, of_vector, kSide, 4, equation.c, equation.low, equation.high);
  });
  jobs.finish();
}

inline void meet_ovus_once(const Ovus& ovus, const Ray& given, Met& met) {
  const auto unit = unit_ray(RayOf<One>{everywhere<One>(given.origin), everywhere<One>(given.direction)});
  meet_balls(ovus, unit, ListSink<Met>{met});
  const DepthEquation<One, 4> equation = equation_along(ovus, unit);
  const Ray ray{given.origin, Vec3(unit.ray.direction.x.v, unit.ray.direction.y.v, unit.ray.direction.z.v)};
  double c[5];
  for (std::size_t k = 0; k < 5; ++k) c[k] = equation.c[k].v;
  PolynomialRoots roots(c, equation.low.v, equation.high.v);
  for (double t; roots.next(t);) {
    const double depth = t + equation.skipped.v;
    if (is_on_side(ovus, ray, depth)) met.add(depth / unit.length.v, kSide);
  }
}

template <class L>
HWY_INLINE MaskOf<L> inside(const Ovus& ovus, const Vec3Of<L>& p, bool inverted) {
  const Vec3Of<L> from_top = p - everywhere<L>(Vec3(0.0, ovus.bottom, 0.0));
  const auto is_in =
      (dot(p, p) < ovus.bottom * ovus.bottom) | (dot(from_top, from_top) < ovus.top * ovus.top) |
      ((p.y > ovus.bottom_ends) & (p.y < ovus.top_begins) & (from_ring_squared(ovus, p) < ovus.tube * ovus.tube));
  return inverted ? !is_in : is_in;
}

FIRSTLIGHT_INSIDE_KERNEL(Ovus)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(meet_ovus);
FIRSTLIGHT_INSIDE_MEMBERS(Ovus)

void Ovus::meet(const Ray& ray, Met& met) const { HWY_NAMESPACE::meet_ovus_once(*this, ray, met); }

void Ovus::meet_block(const RaysAndPlace& asked, Slots& slots) const {
  HWY_DYNAMIC_DISPATCH(meet_ovus)(*this, asked, slots);
}

}  // namespace

ShapePtr make_ovus(double bottom_radius, double top_radius) {
  return std::make_shared<Placed<Ovus>>(Ovus(bottom_radius, top_radius), Transform());
}

}  // namespace firstlight::render
#endif
