#include "render/shape/triangle.h"

#include "render/math/dominant_axis.h"
#include "render/shape/primitives.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/triangle.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/lane_shape-inl.h"

#include <cmath>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE const L& component(const Vec3Of<L>& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// Whether a point of the projection is outside of the edge: twice the signed area between both is negative.
template <class L>
HWY_INLINE MaskOf<L> beyond_edge(const FlatTriangle& flat, std::size_t from, std::size_t to, const L& u, const L& v) {
  const Vec3& a = flat.corners()[from];
  const Vec3& b = flat.corners()[to];
  return (b[flat.u()] - u) * (b[flat.v()] - a[flat.v()]) - (b[flat.v()] - v) * (b[flat.u()] - a[flat.u()]) < 0.0;
}

template <class L, class Sink>
HWY_INLINE void meet(const FlatTriangle& flat, const RayOf<L>& ray, const Sink& met) {
  const auto normal = everywhere<L>(flat.normal());
  const L approach = dot(normal, ray.direction);
  const L depth = -(flat.offset() + dot(normal, ray.origin)) / approach;
  const auto counts = (abs(approach) >= kEpsilon) & (depth >= kNearestCrossing) & (depth <= kMaxDistance);
  if (!any(counts)) return;
  const L u = component(ray.origin, flat.u()) + depth * component(ray.direction, flat.u());
  const L v = component(ray.origin, flat.v()) + depth * component(ray.direction, flat.v());
  const auto outside = beyond_edge(flat, 0, 1, u, v) | beyond_edge(flat, 1, 2, u, v) | beyond_edge(flat, 2, 0, u, v);
  met(0, depth, without(counts, outside));
}

FIRSTLIGHT_MEET_KERNEL(FlatTriangle)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

FIRSTLIGHT_MEET_MEMBERS(FlatTriangle)

namespace {

/// On all sides of the box about a triangle, which scenes may ask for. [POV-Ray 3.7]
constexpr double kPadding = 1e-10;

/// A triangle has two sides and no inside; inverting it changes nothing.
class Triangle final : public Shape {
 public:
  explicit Triangle(const FlatTriangle& flat) : flat_(flat) {}

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override {
    Met met(*this, out);
    if (flat_.valid()) flat_.meet(ray, met);
  }
  void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                  Slots& slots) const override {
    if (flat_.valid()) flat_.meet_block({*this, Transform(), rays, who, nearest_only}, slots);
  }
  bool inside(const Vec3&) const override { return false; }
  std::uint64_t inside_block(const Columns3<double>&, std::uint64_t) const override { return 0; }
  bool is_over_lanes() const override { return true; }
  Vec3 normal(const Vec3&, const Crossing&) const override { return flat_.normal(); }
  Box3 bounds() const override { return flat_.bounds(); }
  Box3 inside_bounds() const override { return flat_.bounds(); }
  ShapePtr placed(const Transform& transform) const override {
    const auto& [a, b, c] = flat_.corners();
    return std::make_shared<Triangle>(FlatTriangle({transform.point(a), transform.point(b), transform.point(c)}));
  }
  bool asks_box() const override { return false; }
  ShapePtr inverted() const override { return std::make_shared<Triangle>(*this); }

 private:
  FlatTriangle flat_;
};

/// A triangle shaded as if it were curved: the normal is interpolated between those given at its corners.
class SmoothTriangle final : public Shape {
 public:
  using Normals = std::array<Vec3, 3>;

  /// `normals` belong to `corners` as they are given here.
  SmoothTriangle(const FlatTriangle::Corners& corners, const Normals& normals) : flat_(corners), normals_(normals) {
    if (flat_.swapped()) std::swap(normals_[0], normals_[1]);
    prepare();
  }

  bool valid() const { return valid_; }
  void crossings(const Ray& ray, std::vector<Crossing>& out) const override {
    Met met(*this, out);
    if (valid_) flat_.meet(ray, met);
  }
  void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                  Slots& slots) const override {
    if (valid_) flat_.meet_block({*this, Transform(), rays, who, nearest_only}, slots);
  }
  bool inside(const Vec3&) const override { return false; }
  std::uint64_t inside_block(const Columns3<double>&, std::uint64_t) const override { return 0; }
  bool is_over_lanes() const override { return true; }
  /// A line from the first corner through the point meets the opposite edge at `v` of its length; the point lies at `u`
  /// of the way there.
  Vec3 normal(const Vec3& point, const Crossing&) const override {
    const auto& [a, b, c] = flat_.corners();
    const auto& [na, nb, nc] = normals_;
    const Vec3 from_a = point - a;
    const double u = from_a.dot(to_edge_);
    if (u < kEpsilon) return na;
    const double v = (from_a[edge_axis_] / u + a[edge_axis_] - b[edge_axis_]) / (c[edge_axis_] - b[edge_axis_]);
    return (na + (nb - na + (nc - nb) * v) * u).normalized();
  }
  Box3 bounds() const override { return valid_ ? flat_.bounds() : Box3(); }
  Box3 inside_bounds() const override { return bounds(); }
  ShapePtr placed(const Transform& transform) const override {
    const auto& [a, b, c] = flat_.corners();
    const auto& [na, nb, nc] = normals_;
    return std::make_shared<SmoothTriangle>(
        FlatTriangle::Corners{transform.point(a), transform.point(b), transform.point(c)},
        Normals{transform.normal(na).normalized(), transform.normal(nb).normalized(),
                transform.normal(nc).normalized()});
  }
  bool asks_box() const override { return false; }
  ShapePtr inverted() const override { return std::make_shared<SmoothTriangle>(*this); }

 private:
  void prepare() {
    if (!flat_.valid()) return;
    const auto& [a, b, c] = flat_.corners();
    edge_axis_ = dominant_axis(c - b);
    const Vec3 along = (b - c).normalized();
    const Vec3 from_c = a - c;
    const Vec3 across = (along * from_c.dot(along) - from_c).normalized();
    to_edge_ = across / -from_c.dot(across);
    // POV-Ray shows the triangle only when all three normals are on one side of it.
    int above = 0;
    int below = 0;
    for (const Vec3& n : normals_) {
      above += flat_.normal().dot(n) > 0.0;
      below += flat_.normal().dot(n) < 0.0;
    }
    valid_ = above == 3 || below == 3;
  }

  FlatTriangle flat_;
  Normals normals_;
  Vec3 to_edge_{0.0};  ///< dotted with a step from the first corner: how much of the way to the opposite edge
  int edge_axis_ = 0;
  bool valid_ = false;
};

}  // namespace

FlatTriangle::FlatTriangle(const Corners& corners) : corners_(corners) {
  auto& [a, b, c] = corners_;
  normal_ = (a - b).cross(c - b);
  const double length = normal_.length();
  if (!(length > 0.0) || !std::isfinite(length)) return;
  valid_ = true;
  normal_ *= 1.0 / length;
  offset_ = -normal_.dot(a);
  const int axis = dominant_axis(normal_);
  u_ = axis == 0 ? 1 : 0;
  v_ = axis == 2 ? 1 : 2;
  swapped_ = (b[u_] - c[u_]) * (b[v_] - a[v_]) < (b[v_] - c[v_]) * (b[u_] - a[u_]);
  if (swapped_) std::swap(a, b);
}

Box3 FlatTriangle::bounds() const {
  Box3 box;
  if (!valid_) return box;
  for (const Vec3& corner : corners_) box.extendBy(corner);
  box.min -= Vec3(kPadding);
  box.max += Vec3(kPadding);
  return box;
}

ShapePtr make_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const FlatTriangle flat({a, b, c});
  return flat.valid() ? std::make_shared<Triangle>(flat) : nullptr;
}

ShapePtr make_smooth_triangle(const Vec3& a, const Vec3& normal_a, const Vec3& b, const Vec3& normal_b, const Vec3& c,
                              const Vec3& normal_c) {
  auto triangle = std::make_shared<SmoothTriangle>(
      FlatTriangle::Corners{a, b, c},
      SmoothTriangle::Normals{normal_a.normalized(), normal_b.normalized(), normal_c.normalized()});
  return triangle->valid() ? triangle : nullptr;
}

}  // namespace firstlight::render
#endif
