#include "render/shape/canonical.h"
#include "render/shape/placed.h"
#include "render/shape/primitives.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/cone.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/lane_shape-inl.h"

#include <cmath>
#include <utility>

#ifndef FIRSTLIGHT_RENDER_SHAPE_CONE
#define FIRSTLIGHT_RENDER_SHAPE_CONE
namespace firstlight::render {
namespace {

enum Face : std::uint32_t { kSide, kBase, kCap };

constexpr double kNearest = 1e-9;  ///< in canonical space

/// x^2 + y^2 = 1 with 0 <= z <= 1.
struct Cylinder {
  static constexpr std::size_t kSlots = 4;
  bool open;

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& p, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    if (at.face == kSide) return Vec3(p.x, p.y, 0.0);
    return Vec3(0.0, 0.0, at.face == kCap ? 1.0 : -1.0);
  }
  Box3 bounds() const { return Box3(Vec3(-1.0, -1.0, 0.0), Vec3(1.0)); }
  Box3 inside_bounds() const { return padded(bounds(), 0.0, 2.0 * kEpsilon); }
};

/// x^2 + y^2 = z^2 with start <= z <= 1: the tip at the origin, the wide end at z = 1.
struct Cone {
  static constexpr std::size_t kSlots = 5;
  double start;
  bool open;

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& p, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    if (at.face == kSide) return Vec3(p.x, p.y, -p.z);
    return Vec3(0.0, 0.0, at.face == kCap ? 1.0 : -1.0);
  }
  Box3 bounds() const { return Box3(Vec3(-1.0, -1.0, start), Vec3(1.0)); }
  // An open cone's tolerance lets points near the tip count that are 1e-5 from the axis, still far within the box.
  Box3 inside_bounds() const { return padded(bounds(), 0.0, 2.0 * kEpsilon); }
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE MaskOf<L> depth_counts(const L& t) {
  return (t > kNearest) & (t < kMaxDistance);
}

/// Where those rays that `may` meet the side do so, if between the heights `low` and 1.
template <class L, class Sink>
HWY_INLINE void meet_side(const UnitRayOf<L>& given, const L& t, double low, const MaskOf<L>& may, std::size_t k,
                          const Sink& met) {
  const L z = given.ray.origin.z + t * given.ray.direction.z;
  met(k, t / given.length, may & depth_counts(t) & (z >= low) & (z <= 1.0), kSide);
}

/// Where the rays meet the end disc at height `z`, of the given squared radius.
template <class L, class Sink>
HWY_INLINE void meet_end(const UnitRayOf<L>& given, double z, double radius_squared, Face face, const MaskOf<L>& may,
                         std::size_t k, const Sink& met) {
  const auto& [p, d] = given.ray;
  const L t = (z - p.z) / d.z;
  const L x = p.x + t * d.x;
  const L y = p.y + t * d.y;
  met(k, t / given.length, may & (x * x + y * y <= radius_squared) & depth_counts(t), face);
}

/// The crossings k and k + 1 with both ends, unless the shape is open.
template <class L, class Sink>
HWY_INLINE void meet_ends(const UnitRayOf<L>& given, double start, double start_squared, bool open, std::size_t k,
                          const Sink& met) {
  const auto steep = abs(given.ray.direction.z) > kEpsilon;
  if (open || !any(steep)) return;
  meet_end(given, 1.0, 1.0, kCap, steep, k, met);
  meet_end(given, start, start_squared, kBase, steep, k + 1, met);
}

template <class L, class Sink>
HWY_INLINE void meet(const Cylinder& cylinder, const RayOf<L>& ray, const Sink& met) {
  const UnitRayOf<L> given = unit_ray(ray);
  const auto& [p, d] = given.ray;
  const L a = d.x * d.x + d.y * d.y;
  const L b = p.x * d.x + p.y * d.y;
  const L c = p.x * p.x + p.y * p.y - 1.0;
  const L discriminant = b * b - a * c;
  const auto hits = (a > kEpsilon) & (discriminant >= 0.0);
  if (any(hits)) {
    const L root = sqrt(discriminant);
    meet_side(given, (-b + root) / a, 0.0, hits, 0, met);
    meet_side(given, (-b - root) / a, 0.0, hits, 1, met);
  }
  meet_ends(given, 0.0, 1.0, cylinder.open, 2, met);
}

template <class L>
HWY_INLINE MaskOf<L> inside(const Cylinder& cylinder, const Vec3Of<L>& p, bool inverted) {
  const double room = cylinder.open ? kEpsilon : -kEpsilon;
  const auto outside = (p.x * p.x + p.y * p.y > 1.0 + room) | (p.z < -room) | (p.z > 1.0 + room);
  return inverted ? outside : !outside;
}

template <class L, class Sink>
HWY_INLINE void meet(const Cone& cone, const RayOf<L>& ray, const Sink& met) {
  const UnitRayOf<L> given = unit_ray(ray);
  const auto& [p, d] = given.ray;
  const L a = d.x * d.x + d.y * d.y - d.z * d.z;
  const L b = p.x * d.x + p.y * d.y - p.z * d.z;
  const L c = p.x * p.x + p.y * p.y - p.z * p.z;
  const auto along_side = abs(a) < kEpsilon;
  const auto once = along_side & (abs(b) > kEpsilon);
  if (any(once)) meet_side(given, -0.5 * c / b, cone.start, once, 0, met);
  const L discriminant = b * b - a * c;
  const auto twice = without(discriminant >= 0.0, along_side);
  if (any(twice)) {
    const L root = sqrt(discriminant);
    meet_side(given, (-b - root) / a, cone.start, twice, 1, met);
    meet_side(given, (-b + root) / a, cone.start, twice, 2, met);
  }
  meet_ends(given, cone.start, cone.start * cone.start, cone.open, 3, met);
}

template <class L>
HWY_INLINE MaskOf<L> inside(const Cone& cone, const Vec3Of<L>& p, bool inverted) {
  const double room = cone.open ? kEpsilon : -kEpsilon;
  const auto outside = (p.x * p.x + p.y * p.y > p.z * p.z + room) | (p.z < cone.start - room) | (p.z > 1.0 + room);
  return inverted ? outside : !outside;
}

FIRSTLIGHT_MEET_KERNEL(Cylinder)
FIRSTLIGHT_INSIDE_KERNEL(Cylinder)
FIRSTLIGHT_MEET_KERNEL(Cone)
FIRSTLIGHT_INSIDE_KERNEL(Cone)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

FIRSTLIGHT_MEET_MEMBERS(Cylinder)
FIRSTLIGHT_INSIDE_MEMBERS(Cylinder)
FIRSTLIGHT_MEET_MEMBERS(Cone)
FIRSTLIGHT_INSIDE_MEMBERS(Cone)

/// A cone without height or width is never met and holds no point.
ShapePtr nothing_at(const Vec3& place) { return make_sphere(place, 0.0); }

}  // namespace

ShapePtr make_cylinder(const Vec3& base, const Vec3& cap, double radius, bool open) {
  const Vec3 axis = cap - base;
  const double height = axis.length();
  if (!(height >= kEpsilon) || radius == 0.0) return nothing_at(base);
  // From the cap down to the base, as POV-Ray places it: its bounding box, which scenes may ask for, shows it.
  return std::make_shared<Placed<Cylinder>>(Cylinder{open}, from_canonical(cap, unit(-axis), radius, height));
}

ShapePtr make_cone(const Vec3& base, double base_radius, const Vec3& cap, double cap_radius, bool open) {
  if (std::abs(cap_radius - base_radius) < kEpsilon) return make_cylinder(base, cap, cap_radius, open);
  Vec3 narrow = base;
  Vec3 wide = cap;
  double narrow_radius = base_radius;
  double wide_radius = cap_radius;
  if (wide_radius < narrow_radius) {
    std::swap(narrow, wide);
    std::swap(narrow_radius, wide_radius);
  }
  Vec3 axis = wide - narrow;
  const double height = axis.length();
  if (!(height >= kEpsilon) || wide_radius == 0.0) return nothing_at(base);
  axis = unit(axis);
  const double missing = narrow_radius * height / (wide_radius - narrow_radius);  // from the tip to the narrow end
  const double whole = missing + height;
  if ((wide_radius - narrow_radius) * height / whole < kEpsilon) {
    return make_cylinder(narrow, wide, wide_radius, open);
  }
  return std::make_shared<Placed<Cone>>(Cone{missing / whole, open},
                                        from_canonical(narrow - axis * missing, axis, wide_radius, whole));
}

}  // namespace firstlight::render
#endif
