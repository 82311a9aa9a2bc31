#include "render/shape/polygon.h"

#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/polygon.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/lane_shape-inl.h"

#include <cmath>
#include <cstddef>
#include <utility>

#ifndef FIRSTLIGHT_RENDER_SHAPE_POLYGON
#define FIRSTLIGHT_RENDER_SHAPE_POLYGON
namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-8;         ///< POV-Ray's for this shape
constexpr double kHalfThickness = 0.001;  ///< of its box
constexpr double kFlat = 1e-10;           ///< how far from the plane a point may be

/// The lines in the plane z = 0.
struct Polygon {
  static constexpr bool kIsLarge = true;
  static constexpr bool kHasInside = false;
  static constexpr std::size_t kSlots = 1;

  std::vector<Vec2> points;

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3&, bool) const { return false; }
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform&, bool, const Columns3<double>&, std::uint64_t) const { return 0; }
  Vec3 normal(const Vec3&, const Crossing&) const { return Vec3(0.0, 0.0, 1.0); }
  Box3 bounds() const {
    Box3 box;
    for (const Vec2& point : points) box.extendBy(Vec3(point.x, point.y, 0.0));
    box.min.z -= kHalfThickness;
    box.max.z += kHalfThickness;
    return box;
  }
  Box3 inside_bounds() const { return bounds(); }
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class Mask>
HWY_INLINE Mask differing(const Mask& a, const Mask& b) {
  return without(a | b, a & b);
}

/// Counts the lines that a ray along x meets. [Haines, Point in Polygon Strategies, 1994]
template <class L>
HWY_INLINE MaskOf<L> holds(const Polygon& polygon, const L& x, const L& y) {
  const std::vector<Vec2>& points = polygon.points;
  auto is_in = y < y;
  std::size_t first = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2& a = points[i - 1];
    const Vec2& b = points[i];
    const auto a_above = L(a.y) >= y;
    const auto b_above = L(b.y) >= y;
    const auto is_left = (b.y - y) * (a.x - b.x) >= (b.x - x) * (a.y - b.y);
    is_in = differing(is_in, without(differing(a_above, b_above), differing(is_left, b_above)));
    if (i + 2 < points.size() && b == points[first]) first = ++i;
  }
  return is_in;
}

template <class L, class Met>
HWY_INLINE void meet(const Polygon& polygon, const RayOf<L>& given, const Met& met) {
  const auto [length, ray] = unit_ray(given);
  const L t = -ray.origin.z / ray.direction.z;
  const auto counts = without((t >= kNearest) & (t <= kMaxDistance), abs(ray.direction.z) < kEpsilon);
  if (!any(counts)) return;
  const auto is_in = holds(polygon, ray.origin.x + t * ray.direction.x, ray.origin.y + t * ray.direction.y);
  met(0, t / length, counts & is_in);
}

FIRSTLIGHT_MEET_KERNEL(Polygon)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

FIRSTLIGHT_MEET_MEMBERS(Polygon)

}  // namespace

ShapePtr make_polygon(const std::vector<Vec3>& points) {
  if (points.empty()) return nullptr;
  const Vec3& origin = points.front();
  std::size_t i = 1;
  while (i < points.size() && (points[i] - origin).length2() <= kEpsilon) ++i;
  if (i >= points.size()) return nullptr;
  const Vec3 first = points[i] - origin;
  Vec3 second(0.0);
  Vec3 normal(0.0);
  for (++i; i < points.size(); ++i) {
    second = points[i] - origin;
    normal = first.cross(second);
    if (second.length2() > kEpsilon && normal.length2() > kEpsilon) break;
  }
  if (i >= points.size()) return nullptr;
  Vec3 u = second.cross(normal);
  Vec3 v = normal.cross(u);
  u = unit(u);
  v = unit(v);
  normal = unit(normal);
  Polygon polygon;
  for (const Vec3& point : points) {
    const Vec3 step = point - origin;
    if (std::abs(step.dot(normal)) > kFlat) return nullptr;
    polygon.points.emplace_back(step.dot(u), step.dot(v));
  }
  const Mat4 to_place(u.x, u.y, u.z, 0.0, v.x, v.y, v.z, 0.0, normal.x, normal.y, normal.z, 0.0, origin.x, origin.y,
                      origin.z, 1.0);
  return std::make_shared<Placed<Polygon>>(std::move(polygon), Transform(to_place));
}

}  // namespace firstlight::render
#endif
