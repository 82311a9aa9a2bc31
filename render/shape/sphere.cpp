#include "render/shape/sphere.h"

#include "render/lanes/math.h"
#include "render/shape/placed.h"
#include "render/shape/primitives.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/sphere.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/through_sphere-inl.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#ifndef FIRSTLIGHT_RENDER_SHAPE_SPHERE
#define FIRSTLIGHT_RENDER_SHAPE_SPHERE
namespace firstlight::render {
namespace {

inline Box3 sphere_box(const Vec3& center, double radius) { return Box3(center - Vec3(radius), center + Vec3(radius)); }

/// Met by rays with directions of unit length.
struct Ball {
  static constexpr std::size_t kSlots = 2;
  Vec3 center;
  double radius_squared;

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
};

/// The sphere that an ellipsoid is before its transformation. Depth limits hold in this space, as in POV-Ray.
struct EllipsoidBase {
  static constexpr bool kAsksBox = false;
  static constexpr std::size_t kSlots = 2;
  Vec3 center;
  double radius;
  Transform turned = {};  ///< before its transformation: Sphere's

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3& point, const Crossing&) const { return point - center; }
  Vec2 uv(const Vec3& point, const Crossing&) const {
    const Vec3 from_center = point - center;
    return sphere_uv(turned.is_identity() ? from_center : turned.inverse_direction(from_center));
  }
  Box3 bounds() const { return sphere_box(center, std::abs(radius)); }
  Box3 inside_bounds() const { return bounds(); }
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE MaskOf<L> depth_counts(const L& depth) {
  return (depth > kNearestCrossing) & (depth < kMaxDistance);
}

template <class L>
HWY_INLINE MaskOf<L> inside_sphere(const Vec3& center, double radius_squared, const Vec3Of<L>& p, bool inverted) {
  const Vec3Of<L> to_center = everywhere<L>(center) - p;
  const L distance_squared = dot(to_center, to_center);
  return inverted ? distance_squared > radius_squared : distance_squared < radius_squared;
}

template <class L, class Sink>
HWY_INLINE void meet(const Ball& ball, const RayOf<L>& ray, const Sink& met) {
  const ThroughSphere<L> through = through_sphere(ray, ball.center, ball.radius_squared);
  met(0, through.enters, through.met & depth_counts(through.enters));
  met(1, through.leaves, through.met & depth_counts(through.leaves));
}
template <class L>
HWY_INLINE MaskOf<L> inside(const Ball& ball, const Vec3Of<L>& p, bool inverted) {
  return inside_sphere(ball.center, ball.radius_squared, p, inverted);
}

template <class L, class Sink>
HWY_INLINE void meet(const EllipsoidBase& base, const RayOf<L>& ray, const Sink& met) {
  const UnitRayOf<L> given = unit_ray(ray);
  const ThroughSphere<L> through = through_sphere(given.ray, base.center, base.radius * base.radius);
  met(0, through.enters / given.length, through.met & depth_counts(through.enters));
  met(1, through.leaves / given.length, through.met & depth_counts(through.leaves));
}
template <class L>
HWY_INLINE MaskOf<L> inside(const EllipsoidBase& base, const Vec3Of<L>& p, bool inverted) {
  return inside_sphere(base.center, base.radius * base.radius, p, inverted);
}

FIRSTLIGHT_MEET_KERNEL(Ball)
FIRSTLIGHT_INSIDE_KERNEL(Ball)
FIRSTLIGHT_MEET_KERNEL(EllipsoidBase)
FIRSTLIGHT_INSIDE_KERNEL(EllipsoidBase)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

FIRSTLIGHT_MEET_MEMBERS(Ball)
FIRSTLIGHT_INSIDE_MEMBERS(Ball)
FIRSTLIGHT_MEET_MEMBERS(EllipsoidBase)
FIRSTLIGHT_INSIDE_MEMBERS(EllipsoidBase)

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

bool meet_sphere(const Ray& ray, const Vec3& center, double radius_squared, double& enters, double& leaves) {
  const HWY_NAMESPACE::RayOf<One> one{HWY_NAMESPACE::everywhere<One>(ray.origin),
                                      HWY_NAMESPACE::everywhere<One>(ray.direction)};
  const auto through = HWY_NAMESPACE::through_sphere(one, center, radius_squared);
  enters = through.enters.v;
  leaves = through.leaves.v;
  return through.met.holds;
}

Vec2 sphere_uv(const Vec3& from_center) {
  const double length = from_center.length();
  if (length == 0.0) return Vec2(0.0);
  const Vec3 d = from_center / length;
  const double latitude = 0.5 + steady::arc_sine(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi;
  const double around = std::sqrt(d.x * d.x + d.z * d.z);
  if (!(around * around > kEpsilon)) return Vec2(0.0, latitude);
  const double angle = steady::arc_cosine(std::clamp(d.x / around, -1.0, 1.0));
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return Vec2((d.z < 0.0 ? kTurn - angle : angle) / kTurn, latitude);
}

Sphere::Sphere(const Vec3& center, double radius, bool inverted, const Transform& turned)
    : center_(center), radius_(radius), inverted_(inverted), turned_(turned) {}

void Sphere::crossings(const Ray& ray, std::vector<Crossing>& out) const {
  Met met(*this, out);
  Ball{center_, radius_squared()}.meet(ray, met);
}

bool Sphere::inside(const Vec3& point) const { return Ball{center_, radius_squared()}.inside(point, inverted_); }

void Sphere::meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                        Slots& slots) const {
  Ball{center_, radius_squared()}.meet_block({*this, Transform(), rays, who, nearest_only}, slots);
}

std::uint64_t Sphere::inside_block(const Columns3<double>& points, std::uint64_t who) const {
  return Ball{center_, radius_squared()}.inside_block(Transform(), inverted_, points, who);
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
#endif
