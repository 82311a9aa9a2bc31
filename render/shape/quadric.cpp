#include "render/shape/quadric.h"

#include "render/math/transform.h"
#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/quadric.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/lane_shape-inl.h"

#include <algorithm>
#include <cmath>
#include <memory>

#ifndef FIRSTLIGHT_RENDER_SHAPE_QUADRIC
#define FIRSTLIGHT_RENDER_SHAPE_QUADRIC
namespace firstlight::render {
namespace {

struct Form {
  static constexpr std::size_t kSlots = 3;
  const QuadricParameters& q;

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE L value(const QuadricParameters& q, const Vec3Of<L>& p) {
  return p.x * (q.square.x * p.x + q.mixed.x * p.y + q.linear.x) +
         p.y * (q.square.y * p.y + q.mixed.z * p.z + q.linear.y) +
         p.z * (q.square.z * p.z + q.mixed.y * p.x + q.linear.z) + q.constant;
}

template <class L, class Sink>
HWY_INLINE void meet(const Form& form, const RayOf<L>& ray, const Sink& met) {
  const QuadricParameters& q = form.q;
  const auto& [o, d] = ray;
  const L a = d.x * (q.square.x * d.x + q.mixed.x * d.y + q.mixed.y * d.z) +
              d.y * (q.square.y * d.y + q.mixed.z * d.z) + d.z * q.square.z * d.z;
  const L b = d.x * (q.square.x * o.x + 0.5 * (q.mixed.x * o.y + q.mixed.y * o.z + q.linear.x)) +
              d.y * (q.square.y * o.y + 0.5 * (q.mixed.x * o.x + q.mixed.z * o.z + q.linear.y)) +
              d.z * (q.square.z * o.z + 0.5 * (q.mixed.y * o.x + q.mixed.z * o.y + q.linear.z));
  const L c = value(q, o);
  const auto add = [&](std::size_t k, const L& depth, const MaskOf<L>& may)
                       HWY_ATTR { met(k, depth, may & (depth > kNearestCrossing) & (depth < kMaxDistance)); };
  const auto linear = a == 0.0;
  const auto once = linear & (b != 0.0);
  if (any(once)) add(0, -0.5 * c / b, once);
  const L discriminant = b * b - a * c;
  const auto twice = without(discriminant > 0.0, linear);
  if (!any(twice)) return;
  const L root = sqrt(discriminant);
  add(1, (-b + root) / a, twice);
  add(2, (-b - root) / a, twice);
}

template <class L>
HWY_INLINE MaskOf<L> inside(const Form& form, const Vec3Of<L>& p, bool inverted) {
  const L v = value(form.q, p);
  return inverted ? v >= 0.0 : v <= 0.0;
}

FIRSTLIGHT_MEET_KERNEL(Form)
FIRSTLIGHT_INSIDE_KERNEL(Form)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

FIRSTLIGHT_MEET_MEMBERS(Form)
FIRSTLIGHT_INSIDE_MEMBERS(Form)

/// Where a box ends that POV-Ray takes for one without end.
constexpr double kLongest = 1e6;

/// The form p M p^T with p = (x, y, z, 1), of which only the upper half of M is filled.
Mat4 matrix_of(const QuadricParameters& q) {
  Mat4 m(0.0);
  m[0][0] = q.square.x;
  m[1][1] = q.square.y;
  m[2][2] = q.square.z;
  m[0][1] = q.mixed.x;
  m[0][2] = q.mixed.y;
  m[1][2] = q.mixed.z;
  m[0][3] = q.linear.x;
  m[1][3] = q.linear.y;
  m[2][3] = q.linear.z;
  m[3][3] = q.constant;
  return m;
}

QuadricParameters quadric_of(const Mat4& m) {
  QuadricParameters q;
  q.square = Vec3(m[0][0], m[1][1], m[2][2]);
  q.mixed = Vec3(m[0][1] + m[1][0], m[0][2] + m[2][0], m[1][2] + m[2][1]);
  q.linear = Vec3(m[0][3] + m[3][0], m[1][3] + m[3][1], m[2][3] + m[3][2]);
  q.constant = m[3][3];
  return q;
}

/// Where a quadric along the axes lies: ellipsoids, cylinders of elliptic section, and the half space of elliptic
/// paraboloids. Others have no end.
Box3 box_of(const QuadricParameters& q) {
  Box3 box = boundless_box();
  if (q.mixed != Vec3(0.0)) return box;
  double level = -q.constant;
  double sign = 0.0;
  int squares = 0;
  int slope_axis = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = q.square[axis];
    if (a == 0.0 && q.linear[axis] != 0.0) {
      if (slope_axis >= 0) return box;
      slope_axis = axis;
    }
    if (a == 0.0) continue;
    if (sign * a < 0.0) return box;
    sign = a;
    ++squares;
    level += q.linear[axis] * q.linear[axis] / (4.0 * a);
  }
  if (slope_axis >= 0) {
    if (squares < 2) return box;
    // sum of a (x - m)^2 = level - slope * y
    const double slope = q.linear[slope_axis];
    (slope * sign > 0.0 ? box.max : box.min)[slope_axis] = level / slope;
    return box;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double a = q.square[axis];
    if (a == 0.0) continue;
    const double half = level / a > 0.0 ? std::sqrt(level / a) : 0.0;
    const double middle = -q.linear[axis] / (2.0 * a);
    box.min[axis] = middle - half;
    box.max[axis] = middle + half;
  }
  return box;
}

/// A quadric in world space: moves change its coefficients. [POV-Ray 3.7]
class Quadric final : public Shape {
 public:
  Quadric(const QuadricParameters& q, const Box3& box, bool inverted) : q_(q), box_(box), inverted_(inverted) {}

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override {
    Met met(*this, out);
    Form{q_}.meet(ray, met);
  }
  bool inside(const Vec3& point) const override { return Form{q_}.inside(point, inverted_); }
  void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                  Slots& slots) const override {
    Form{q_}.meet_block({*this, Transform(), rays, who, nearest_only}, slots);
  }
  std::uint64_t inside_block(const Columns3<double>& points, std::uint64_t who) const override {
    return Form{q_}.inside_block(Transform(), inverted_, points, who);
  }
  bool is_over_lanes() const override { return true; }
  Vec3 normal(const Vec3& p, const Crossing&) const override {
    const Vec3 n(2.0 * q_.square.x * p.x + q_.mixed.x * p.y + q_.mixed.y * p.z + q_.linear.x,
                 q_.mixed.x * p.x + 2.0 * q_.square.y * p.y + q_.mixed.z * p.z + q_.linear.y,
                 q_.mixed.y * p.x + q_.mixed.z * p.y + 2.0 * q_.square.z * p.z + q_.linear.z);
    const double length = n.length();
    if (length == 0.0) return Vec3(1.0, 0.0, 0.0);
    return n / (inverted_ ? -length : length);
  }
  Box3 bounds() const override { return box_; }
  Box3 inside_bounds() const override { return holds_box() != inverted_ ? box_ : boundless_box(); }
  Box3 outside_bounds() const override { return holds_box() == inverted_ ? box_ : boundless_box(); }
  ShapePtr placed(const Transform& transform) const override {
    const Mat4& back = transform.inverse_matrix();
    const Box3 box = is_bounded(box_) ? transform.box(box_) : boundless_box();
    return std::make_shared<Quadric>(quadric_of(back * matrix_of(q_) * back.transposed()), box, inverted_);
  }
  ShapePtr inverted() const override { return std::make_shared<Quadric>(q_, box_, !inverted_); }

 private:
  /// Whether what is inside, or else what is outside, lies within the box.
  bool holds_box() const { return q_.square.x + q_.square.y + q_.square.z > 0.0; }

  QuadricParameters q_;
  Box3 box_;  ///< about the surface
  bool inverted_;
};

}  // namespace

ShapePtr make_quadric(const QuadricParameters& parameters) {
  Box3 box = box_of(parameters);
  const Vec3 size = box.max - box.min;
  if (std::max({size.x, size.y, size.z}) > kLongest && is_bounded(box)) box = boundless_box();
  return std::make_shared<Quadric>(parameters, box, false);
}

}  // namespace firstlight::render
#endif
