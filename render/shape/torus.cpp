#include "render/lanes/math.h"
#include "render/shape/placed.h"
#include "render/shape/primitives.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/torus.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/depth_roots-inl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#ifndef FIRSTLIGHT_RENDER_SHAPE_TORUS
#define FIRSTLIGHT_RENDER_SHAPE_TORUS
namespace firstlight::render {
namespace {

constexpr double kNearestTorusCrossing = 1e-4;  ///< in world space; POV-Ray's for this shape
constexpr double kRoom = 1e-9;                  ///< relative: the search goes this much beyond the bounding shapes

/// A tube of radius `minor` around a circle of radius `major` in the plane y = 0.
///
/// The surface is (|p|^2 - R^2 - r^2)^2 + 4 R^2 (y^2 - r^2) = 0, along a ray a quartic in the depth. When r > R that
/// surface has a second, inner sheet; POV-Ray shows it, and so do we.
struct Torus {
  double major;
  double minor;

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3& p, const Crossing&) const {
    const double from_axis = std::sqrt(p.x * p.x + p.z * p.z);
    if (!(from_axis > kEpsilon)) return p;
    const double to_circle = major / from_axis;
    return Vec3(p.x - p.x * to_circle, p.y, p.z - p.z * to_circle);
  }
  /// Around the axis, and around the tube, from 0 to 1. [POV-Ray 3.7]
  Vec2 uv(const Vec3& p, const Crossing&) const {
    const double from_circle = std::sqrt(p.x * p.x + p.z * p.z) - major;
    const auto turns = [](double angle) { return (angle + std::numbers::pi) / (2.0 * std::numbers::pi); };
    return Vec2(1.0 - turns(steady::arc_tangent(p.z, p.x)), turns(steady::arc_tangent(p.y, from_circle)));
  }
  Box3 bounds() const { return box(std::abs(major) + std::abs(minor)); }
  Box3 given_bounds() const { return box(std::abs(major + minor)); }
  Box3 inside_bounds() const { return bounds(); }

  bool has_negative_radius() const { return major < 0.0 || minor < 0.0; }
  /// The thick cylinder that POV-Ray asks first. Where a radius is negative it is not around all of the tube: its height
  /// is from -minor to minor, its radii are |major - minor|, or 0 if that is negative, and |major + minor|.
  bool meets_hull(const Vec3& p, const Vec3& d) const {
    const double inner = major < minor ? 0.0 : (major - minor) * (major - minor);
    const double outer = (major + minor) * (major + minor);
    const auto counts = [](double t) { return t > kEpsilon && t < kMaxDistance; };
    const auto square = [&](double t) {
      const double x = p.x + t * d.x;
      const double z = p.z + t * d.z;
      return x * x + z * z;
    };
    if (std::abs(d.y) < kEpsilon) {
      if (p.y < -minor || p.y > minor) return false;
    } else {
      for (const double height : {minor, -minor}) {
        const double t = (height - p.y) / d.y;
        if (counts(t) && square(t) >= inner && square(t) <= outer) return true;
      }
    }
    const double a = d.x * d.x + d.z * d.z;
    if (!(a > kEpsilon)) return false;
    const double b = p.x * d.x + p.z * d.z;
    for (const double radius_squared : {outer, inner}) {
      const double discriminant = b * b - a * (p.x * p.x + p.z * p.z - radius_squared);
      if (!(discriminant >= 0.0)) continue;
      for (const double root : {std::sqrt(discriminant), -std::sqrt(discriminant)}) {
        const double t = (root - b) / a;
        const double height = p.y + t * d.y;
        if (counts(t) && height >= -minor && height <= minor) return true;
      }
    }
    return false;
  }

 private:
  Box3 box(double outer) const {
    const double top = std::abs(minor);
    return Box3(Vec3(-outer, -top, -outer), Vec3(outer, top, outer));
  }
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Depths are counted from the point nearest to the centre: there the coefficients keep their digits, however far away the
/// ray starts.
template <class L>
HWY_INLINE DepthEquation<L, 4> equation_along(const Torus& torus, const RayOf<L>& given) {
  const auto [p, d, skipped, length] = near_ray(unit_ray(given));
  const double thickness = std::abs(torus.minor);
  const double reach = (std::abs(torus.major) + thickness) * (1.0 + kRoom);
  const L distance_squared = dot(p, p);
  const L half = sqrt(reach * reach - distance_squared);  // no number where the ray passes outside
  L low = max(-half, kNearestTorusCrossing * length - skipped);
  L high = min(half, kMaxDistance * length - skipped);
  const double top = thickness * (1.0 + kRoom);
  const L t1 = (-top - p.y) / d.y;
  const L t2 = (top - p.y) / d.y;
  const auto is_steep = abs(d.y) > kEpsilon;
  low = select(is_steep, max(low, min(t1, t2)), low);
  high = select(is_steep, min(high, max(t1, t2)), high);
  high = select(without(abs(p.y) > top, is_steep), low, high);

  const double r2_major = torus.major * torus.major;
  const double r2_minor = torus.minor * torus.minor;
  const L k1 = distance_squared - r2_major - r2_minor;
  const L k2 = dot(p, d);
  return {{k1 * k1 + 4.0 * r2_major * (p.y * p.y - r2_minor), 4.0 * (k1 * k2 + 2.0 * r2_major * p.y * d.y),
           2.0 * k1 + 4.0 * k2 * k2 + 4.0 * r2_major * d.y * d.y, 4.0 * k2, L(1.0)},
          low,
          high,
          skipped,
          length};
}

template <class L>
HWY_INLINE L crossing_at(const L& t, const L& length, MaskOf<L>& counts) {
  const L depth = t / length;
  counts = (depth > kNearestTorusCrossing) & (depth < kMaxDistance);
  return depth;
}

void meet_torus(const Torus& torus, const RaysAndPlace& asked, Slots& slots) {
  DepthEquations equations;
  equations.begin(4);
  for_each_vector(asked, [&](const RayOf<Lanes>& ray, std::size_t i, std::uint64_t of_vector)
                             HWY_ATTR { equations.set(i, of_vector, equation_along(torus, ray)); });
  meet_at_roots(equations, asked, slots, crossing_at<Lanes>);
}

template <class L>
HWY_INLINE MaskOf<L> inside(const Torus& torus, const Vec3Of<L>& p, bool inverted) {
  const L from_circle = sqrt(p.x * p.x + p.z * p.z) - torus.major;
  const auto is_in = p.y * p.y + from_circle * from_circle <= torus.minor * torus.minor;
  return inverted ? !is_in : is_in;
}

FIRSTLIGHT_INSIDE_KERNEL(Torus)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(meet_torus);
FIRSTLIGHT_INSIDE_MEMBERS(Torus)

void Torus::meet(const Ray& ray, Met& met) const {
  if (has_negative_radius() && !meets_hull(ray.origin, UnitRay(ray).ray.direction)) return;
  const HWY_NAMESPACE::RayOf<One> given{HWY_NAMESPACE::everywhere<One>(ray.origin),
                                        HWY_NAMESPACE::everywhere<One>(ray.direction)};
  HWY_NAMESPACE::meet_at_roots(HWY_NAMESPACE::equation_along(*this, given), 4, met, HWY_NAMESPACE::crossing_at<One>);
}

void Torus::meet_block(const RaysAndPlace& asked, Slots& slots) const {
  if (has_negative_radius()) return asked.shape.Shape::meet_block(asked.rays, asked.who, asked.nearest_only, slots);
  HWY_DYNAMIC_DISPATCH(meet_torus)(*this, asked, slots);
}

}  // namespace

ShapePtr make_torus(double major, double minor) {
  return std::make_shared<Placed<Torus>>(Torus{major, minor}, Transform());
}

}  // namespace firstlight::render
#endif
