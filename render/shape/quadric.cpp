#include "render/shape/quadric.h"

#include "render/math/transform.h"
#include "render/shape/tolerance.h"

#include <cmath>
#include <algorithm>
#include <memory>

namespace firstlight::render {
namespace {

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
    const Vec3& d = ray.direction;
    const Vec3& o = ray.origin;
    const double a = d.x * (q_.square.x * d.x + q_.mixed.x * d.y + q_.mixed.y * d.z) +
                     d.y * (q_.square.y * d.y + q_.mixed.z * d.z) + d.z * q_.square.z * d.z;
    const double b = d.x * (q_.square.x * o.x + 0.5 * (q_.mixed.x * o.y + q_.mixed.y * o.z + q_.linear.x)) +
                     d.y * (q_.square.y * o.y + 0.5 * (q_.mixed.x * o.x + q_.mixed.z * o.z + q_.linear.y)) +
                     d.z * (q_.square.z * o.z + 0.5 * (q_.mixed.y * o.x + q_.mixed.z * o.y + q_.linear.z));
    const double c = value(o);
    const auto add = [&](double depth) {
      if (depth > kNearestCrossing && depth < kMaxDistance) out.push_back({depth, this, 0, 0, {}});
    };
    if (a == 0.0) {
      if (b != 0.0) add(-0.5 * c / b);
      return;
    }
    const double discriminant = b * b - a * c;
    if (!(discriminant > 0.0)) return;
    const double root = std::sqrt(discriminant);
    add((-b + root) / a);
    add((-b - root) / a);
  }
  bool inside(const Vec3& point) const override { return inverted_ ? value(point) >= 0.0 : value(point) <= 0.0; }
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
  double value(const Vec3& p) const {
    return p.x * (q_.square.x * p.x + q_.mixed.x * p.y + q_.linear.x) +
           p.y * (q_.square.y * p.y + q_.mixed.z * p.z + q_.linear.y) +
           p.z * (q_.square.z * p.z + q_.mixed.y * p.x + q_.linear.z) + q_.constant;
  }
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
