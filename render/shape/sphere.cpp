#include "render/shape/sphere.h"

#include "render/shape/placed.h"
#include "render/shape/primitives.h"

#include <algorithm>
#include <numbers>

namespace firstlight::render {
namespace {

Box3 sphere_box(const Vec3& center, double radius) { return Box3(center - Vec3(radius), center + Vec3(radius)); }

/// The sphere that an ellipsoid is before its transformation. Depth limits hold in this space, as in POV-Ray.
struct EllipsoidBase {
  static constexpr bool kAsksBox = false;
  Vec3 center;
  double radius;
  Transform turned = {};  ///< before its transformation: Sphere's

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
  Vec3 normal(const Vec3& point, const Crossing&) const { return point - center; }
  Vec2 uv(const Vec3& point, const Crossing&) const {
    const Vec3 from_center = point - center;
    return sphere_uv(turned.is_identity() ? from_center : turned.inverse_direction(from_center));
  }
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

Vec2 sphere_uv(const Vec3& from_center) {
  const double length = from_center.length();
  if (length == 0.0) return Vec2(0.0);
  const Vec3 d = from_center / length;
  const double latitude = 0.5 + std::asin(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi;
  const double around = std::sqrt(d.x * d.x + d.z * d.z);
  if (!(around * around > kEpsilon)) return Vec2(0.0, latitude);
  const double angle = std::acos(std::clamp(d.x / around, -1.0, 1.0));
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return Vec2((d.z < 0.0 ? kTurn - angle : angle) / kTurn, latitude);
}

Sphere::Sphere(const Vec3& center, double radius, bool inverted, const Transform& turned)
    : center_(center), radius_(radius), inverted_(inverted), turned_(turned) {}

void Sphere::crossings(const Ray& ray, std::vector<Crossing>& out) const {
  double enters;
  double leaves;
  if (!meet_sphere(ray, center_, radius_squared(), enters, leaves)) return;
  if (sphere_depth_counts(enters)) out.push_back({enters, this, 0, 0});
  if (sphere_depth_counts(leaves)) out.push_back({leaves, this, 0, 0});
}

bool Sphere::inside(const Vec3& point) const {
  const double distance_squared = (center_ - point).length2();
  return inverted_ ? distance_squared > radius_squared() : distance_squared < radius_squared();
}

Vec3 Sphere::normal(const Vec3& point, const Crossing&) const {
  const Vec3 n = (point - center_) * (1.0 / radius_);
  return inverted_ ? -n : n;
}

void Sphere::normals(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns3<double>& out) const {
  const double scale = inverted_ ? -(1.0 / radius_) : 1.0 / radius_;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double middle = center_[axis];
    for (std::size_t i = first; i < end; ++i) out.of[axis][i] = (places.point.of[axis][i] - middle) * scale;
  }
}

Vec2 Sphere::uv(const Vec3& point, const Crossing& crossing) const {
  return EllipsoidBase{center_, radius_, turned_}.uv(point, crossing);
}

Box3 Sphere::bounds() const { return sphere_box(center_, std::abs(radius_)); }

Box3 Sphere::given_bounds() const { return sphere_box(center_, radius_); }

Box3 Sphere::inside_bounds() const { return inverted_ ? boundless_box() : bounds(); }

Box3 Sphere::outside_bounds() const { return inverted_ ? bounds() : boundless_box(); }

ShapePtr Sphere::placed(const Transform& transform) const {
  const double factor = similarity_factor(transform.matrix());
  if (factor > 0.0) {
    return std::make_shared<Sphere>(transform.point(center_), radius_ * factor, inverted_, turned_by(transform));
  }
  return std::make_shared<Placed<EllipsoidBase>>(EllipsoidBase{center_, radius_, turned_}, transform, inverted_);
}

/// All that has turned it, with `transform`; the identity while that is nothing but moves and growth.
Transform Sphere::turned_by(const Transform& transform) const {
  const Mat4& m = transform.matrix();
  bool turns = !(m[0][0] > 0.0 && m[1][1] > 0.0 && m[2][2] > 0.0);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) turns = turns || (row != column && m[row][column] != 0.0);
  }
  return turns ? turned_.then(transform) : turned_;
}

ShapePtr Sphere::inverted() const { return std::make_shared<Sphere>(center_, radius_, !inverted_, turned_); }

ShapePtr make_sphere(const Vec3& center, double radius) { return std::make_shared<Sphere>(center, radius, false); }

}  // namespace firstlight::render
