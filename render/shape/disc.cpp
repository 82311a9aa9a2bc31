#include "render/shape/canonical.h"
#include "render/shape/placed.h"
#include "render/shape/primitives.h"
#include "render/shape/tolerance.h"

#include <cmath>

namespace firstlight::render {
namespace {

/// Half the thickness of the box about a disc, which scenes may ask for. [POV-Ray 3.7]
constexpr double kHalfThickness = 0.001;

/// A ring around the origin in the plane z = 0. Inside is all that lies below the plane.
struct Disc {
  double hole_squared;
  double radius_squared;

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    const Vec3& d = ray.direction;
    if (!(std::abs(d.z) > kEpsilon)) return;
    const double t = -ray.origin.z / d.z;
    if (!(t >= 0.0)) return;
    const double x = ray.origin.x + t * d.x;
    const double y = ray.origin.y + t * d.y;
    const double r2 = x * x + y * y;
    if (r2 < hole_squared || r2 > radius_squared) return;
    const double depth = t / length;
    if (depth > kNearestCrossing && depth < kMaxDistance) met.add(depth);
  }
  bool inside(const Vec3& point, bool inverted) const { return (point.z < 0.0) != inverted; }
  Vec3 normal(const Vec3&, const Crossing&) const { return Vec3(0.0, 0.0, 1.0); }
  Box3 bounds() const {
    const double r = std::sqrt(radius_squared);
    return Box3(Vec3(-r, -r, -kHalfThickness), Vec3(r, r, kHalfThickness));
  }
  Box3 inside_bounds() const { return boundless_box(); }
};

}  // namespace

ShapePtr make_disc(const Vec3& center, const Vec3& normal, double radius, double hole_radius) {
  return std::make_shared<Placed<Disc>>(Disc{hole_radius * hole_radius, radius * radius},
                                        from_canonical(center, unit(normal), 1.0, 1.0));
}

}  // namespace firstlight::render
