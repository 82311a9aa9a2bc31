#include "render/shape/sphere.h"

#include "render/shape/placed.h"
#include "render/shape/primitives.h"

namespace firstlight::render {
namespace {

Box3 sphere_box(const Vec3& center, double radius) { return Box3(center - Vec3(radius), center + Vec3(radius)); }

/// The sphere that an ellipsoid is before its transformation. Depth limits hold in this space, as in POV-Ray.
struct EllipsoidBase {
  static constexpr bool kAsksBox = false;
  Vec3 center;
  double radius;

  void meet(const Ray& given, Met& met) const {
    const auto [length, ray] = UnitRay(given);
    double enters;
    double leaves;
    if (!meet_sphere(ray, center, radius * radius, enters, leaves)) return;
    if (sphere_depth_counts(enters)) met.add(enters / length);
    if (sphere_depth_counts(leaves)) met.add(leaves / length);
  }
  bool inside(const Vec3& point, bool inverted) const {
    const double distance_squared = (center - point).length2();
    return inverted ? distance_squared > radius * radius : distance_squared < radius * radius;
  }
  Vec3 normal(const Vec3& point, std::uint32_t) const { return point - center; }
  Box3 bounds() const { return sphere_box(center, std::abs(radius)); }
  Box3 inside_bounds() const { return bounds(); }
};

/// The factor by which `m` scales all directions alike, or 0 when it does not.
double similarity_factor(const Mat4& m) {
  const Vec3 rows[3] = {{m[0][0], m[0][1], m[0][2]}, {m[1][0], m[1][1], m[1][2]}, {m[2][0], m[2][1], m[2][2]}};
  const double square = rows[0].length2();
  const double tolerance = 1e-13 * square;
  for (int i = 1; i < 3; ++i) {
    if (!(std::abs(rows[i].length2() - square) <= tolerance)) return 0.0;
  }
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(rows[i].dot(rows[(i + 1) % 3])) <= tolerance)) return 0.0;
  }
  return std::sqrt(square);
}

}  // namespace

Sphere::Sphere(const Vec3& center, double radius, bool inverted)
    : center_(center), radius_(radius), inverted_(inverted) {}

void Sphere::crossings(const Ray& ray, std::vector<Crossing>& out) const {
  double enters;
  double leaves;
  if (!meet_sphere(ray, center_, radius_squared(), enters, leaves)) return;
  if (sphere_depth_counts(enters)) out.push_back({enters, this, 0, 0});
  if (sphere_depth_counts(leaves)) out.push_back({leaves, this, 0, 0});
}

bool Sphere::inside(const Vec3& point) const { return EllipsoidBase{center_, radius_}.inside(point, inverted_); }

Vec3 Sphere::normal(const Vec3& point, const Crossing&) const {
  const Vec3 n = (point - center_) * (1.0 / radius_);
  return inverted_ ? -n : n;
}

Box3 Sphere::bounds() const { return sphere_box(center_, std::abs(radius_)); }

Box3 Sphere::given_bounds() const { return sphere_box(center_, radius_); }

Box3 Sphere::inside_bounds() const { return inverted_ ? boundless_box() : bounds(); }

Box3 Sphere::outside_bounds() const { return inverted_ ? bounds() : boundless_box(); }

ShapePtr Sphere::placed(const Transform& transform) const {
  const double factor = similarity_factor(transform.matrix());
  if (factor > 0.0) return std::make_shared<Sphere>(transform.point(center_), radius_ * factor, inverted_);
  return std::make_shared<Placed<EllipsoidBase>>(EllipsoidBase{center_, radius_}, transform, inverted_);
}

ShapePtr Sphere::inverted() const { return std::make_shared<Sphere>(center_, radius_, !inverted_); }

ShapePtr make_sphere(const Vec3& center, double radius) { return std::make_shared<Sphere>(center, radius, false); }

}  // namespace firstlight::render
