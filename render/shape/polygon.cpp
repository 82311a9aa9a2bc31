#include "render/shape/polygon.h"

#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-8;         ///< POV-Ray's for this shape
constexpr double kHalfThickness = 0.001;  ///< of its box
constexpr double kFlat = 1e-10;           ///< how far from the plane a point may be

/// The lines in the plane z = 0.
struct Polygon {
  static constexpr bool kIsLarge = true;
  static constexpr bool kHasInside = false;

  std::vector<Vec2> points;

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    if (std::abs(ray.direction.z) < kEpsilon) return;
    const double t = -ray.origin.z / ray.direction.z;
    if (!(t >= kNearest && t <= kMaxDistance)) return;
    if (holds(ray.origin.x + t * ray.direction.x, ray.origin.y + t * ray.direction.y)) met.add(t / length);
  }
  bool inside(const Vec3&, bool) const { return false; }
  Vec3 normal(const Vec3&, const Crossing&) const { return Vec3(0.0, 0.0, 1.0); }
  Box3 bounds() const {
    Box3 box;
    for (const Vec2& point : points) box.extendBy(Vec3(point.x, point.y, 0.0));
    box.min.z -= kHalfThickness;
    box.max.z += kHalfThickness;
    return box;
  }
  Box3 inside_bounds() const { return bounds(); }

 private:
  /// Counts the lines that a ray along x meets. [Haines, Point in Polygon Strategies, 1994]
  bool holds(double x, double y) const {
    bool is_in = false;
    std::size_t first = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec2& a = points[i - 1];
      const Vec2& b = points[i];
      const bool a_above = a.y >= y;
      const bool b_above = b.y >= y;
      if (a_above != b_above && ((b.y - y) * (a.x - b.x) >= (b.x - x) * (a.y - b.y)) == b_above) is_in = !is_in;
      if (i + 2 < points.size() && b == points[first]) first = ++i;
    }
    return is_in;
  }
};

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
