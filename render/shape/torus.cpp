#include "render/lanes/math.h"
#include "render/math/polynomial.h"
#include "render/shape/placed.h"
#include "render/shape/primitives.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    const Vec3& d = ray.direction;
    // Depths are counted from the point nearest to the centre: there the coefficients keep their digits, however far
    // away the ray starts.
    const double skipped = -given.origin.dot(d);
    const Vec3 p = given.origin + d * skipped;
    if ((major < 0.0 || minor < 0.0) && !meets_hull(given.origin, d)) return;
    const double thickness = std::abs(minor);
    const double reach = (std::abs(major) + thickness) * (1.0 + kRoom);
    const double distance_squared = p.length2();
    const double half_squared = reach * reach - distance_squared;
    if (!(half_squared > 0.0)) return;
    const double half = std::sqrt(half_squared);
    double low = std::max(-half, kNearestTorusCrossing * length - skipped);
    double high = std::min(half, kMaxDistance * length - skipped);
    const double top = thickness * (1.0 + kRoom);
    if (std::abs(d.y) > kEpsilon) {
      const double t1 = (-top - p.y) / d.y;
      const double t2 = (top - p.y) / d.y;
      low = std::max(low, std::min(t1, t2));
      high = std::min(high, std::max(t1, t2));
    } else if (std::abs(p.y) > top) {
      return;
    }
    if (!(low < high)) return;

    const double r2_major = major * major;
    const double r2_minor = minor * minor;
    const double k1 = distance_squared - r2_major - r2_minor;
    const double k2 = p.dot(d);
    const std::array<double, 5> quartic = {k1 * k1 + 4.0 * r2_major * (p.y * p.y - r2_minor),
                                           4.0 * (k1 * k2 + 2.0 * r2_major * p.y * d.y),
                                           2.0 * k1 + 4.0 * k2 * k2 + 4.0 * r2_major * d.y * d.y, 4.0 * k2, 1.0};
    PolynomialRoots roots(quartic, low, high);
    for (double t; !met.is_enough() && roots.next(t);) {
      const double depth = (t + skipped) / length;
      if (depth > kNearestTorusCrossing && depth < kMaxDistance) met.add(depth);
    }
  }
  bool inside(const Vec3& p, bool inverted) const {
    const double from_circle = std::sqrt(p.x * p.x + p.z * p.z) - major;
    return (p.y * p.y + from_circle * from_circle <= minor * minor) != inverted;
  }
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

 private:
  Box3 box(double outer) const {
    const double top = std::abs(minor);
    return Box3(Vec3(-outer, -top, -outer), Vec3(outer, top, outer));
  }
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
};

}  // namespace

ShapePtr make_torus(double major, double minor) {
  return std::make_shared<Placed<Torus>>(Torus{major, minor}, Transform());
}

}  // namespace firstlight::render
