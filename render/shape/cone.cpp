#include "render/shape/canonical.h"
#include "render/shape/placed.h"
#include "render/shape/primitives.h"
#include "render/shape/tolerance.h"

#include <cmath>
#include <utility>

namespace firstlight::render {
namespace {

enum Face : std::uint32_t { kSide, kBase, kCap };

constexpr double kNearest = 1e-9;  ///< in canonical space

bool depth_counts(double t) { return t > kNearest && t < kMaxDistance; }

/// Appends where the ray meets the end disc at height `z`, of the given squared radius.
void meet_end(const Ray& ray, double length, double z, double radius_squared, Face face, Met& met) {
  const double t = (z - ray.origin.z) / ray.direction.z;
  const double x = ray.origin.x + t * ray.direction.x;
  const double y = ray.origin.y + t * ray.direction.y;
  if (x * x + y * y <= radius_squared && depth_counts(t)) met.add(t / length, face);
}

/// x^2 + y^2 = 1 with 0 <= z <= 1.
struct Cylinder {
  bool open;

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    const Vec3& p = ray.origin;
    const Vec3& d = ray.direction;
    const double a = d.x * d.x + d.y * d.y;
    if (a > kEpsilon) {
      const double b = p.x * d.x + p.y * d.y;
      const double c = p.x * p.x + p.y * p.y - 1.0;
      const double discriminant = b * b - a * c;
      if (discriminant >= 0.0) {
        const double root = std::sqrt(discriminant);
        meet_side(ray, length, (-b + root) / a, met);
        meet_side(ray, length, (-b - root) / a, met);
      }
    }
    if (!open && std::abs(d.z) > kEpsilon) {
      meet_end(ray, length, 1.0, 1.0, kCap, met);
      meet_end(ray, length, 0.0, 1.0, kBase, met);
    }
  }
  bool inside(const Vec3& p, bool inverted) const {
    const double room = open ? kEpsilon : -kEpsilon;
    const bool outside = p.x * p.x + p.y * p.y > 1.0 + room || p.z < -room || p.z > 1.0 + room;
    return outside == inverted;
  }
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    if (at.face == kSide) return Vec3(p.x, p.y, 0.0);
    return Vec3(0.0, 0.0, at.face == kCap ? 1.0 : -1.0);
  }
  Box3 bounds() const { return Box3(Vec3(-1.0, -1.0, 0.0), Vec3(1.0)); }
  Box3 inside_bounds() const { return padded(bounds(), 0.0, 2.0 * kEpsilon); }

 private:
  static void meet_side(const Ray& ray, double length, double t, Met& met) {
    const double z = ray.origin.z + t * ray.direction.z;
    if (depth_counts(t) && z >= 0.0 && z <= 1.0) met.add(t / length, kSide);
  }
};

/// x^2 + y^2 = z^2 with start <= z <= 1: the tip at the origin, the wide end at z = 1.
struct Cone {
  double start;
  bool open;

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    const Vec3& p = ray.origin;
    const Vec3& d = ray.direction;
    const double a = d.x * d.x + d.y * d.y - d.z * d.z;
    const double b = p.x * d.x + p.y * d.y - p.z * d.z;
    const double c = p.x * p.x + p.y * p.y - p.z * p.z;
    if (std::abs(a) < kEpsilon) {  // along the side: one crossing at most
      if (std::abs(b) > kEpsilon) meet_side(ray, length, -0.5 * c / b, met);
    } else {
      const double discriminant = b * b - a * c;
      if (discriminant >= 0.0) {
        const double root = std::sqrt(discriminant);
        meet_side(ray, length, (-b - root) / a, met);
        meet_side(ray, length, (-b + root) / a, met);
      }
    }
    if (!open && std::abs(d.z) > kEpsilon) {
      meet_end(ray, length, 1.0, 1.0, kCap, met);
      meet_end(ray, length, start, start * start, kBase, met);
    }
  }
  bool inside(const Vec3& p, bool inverted) const {
    const double room = open ? kEpsilon : -kEpsilon;
    const bool outside = p.x * p.x + p.y * p.y > p.z * p.z + room || p.z < start - room || p.z > 1.0 + room;
    return outside == inverted;
  }
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    if (at.face == kSide) return Vec3(p.x, p.y, -p.z);
    return Vec3(0.0, 0.0, at.face == kCap ? 1.0 : -1.0);
  }
  Box3 bounds() const { return Box3(Vec3(-1.0, -1.0, start), Vec3(1.0)); }
  // An open cone's tolerance lets points near the tip count that are 1e-5 from the axis, still far within the box.
  Box3 inside_bounds() const { return padded(bounds(), 0.0, 2.0 * kEpsilon); }

 private:
  void meet_side(const Ray& ray, double length, double t, Met& met) const {
    const double z = ray.origin.z + t * ray.direction.z;
    if (depth_counts(t) && z >= start && z <= 1.0) met.add(t / length, kSide);
  }
};

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
