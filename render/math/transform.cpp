#include "render/math/transform.h"

#include "render/lanes/math.h"
#include "render/math/bounds.h"

#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

double determinant3(const Mat4& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Inverse of an affine matrix: the linear part by its adjugate, then the offset taken back through it.
Mat4 affine_inverse(const Mat4& m) {
  const double scale = 1.0 / determinant3(m);
  Mat4 inverse;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3;
      const int j2 = (j + 2) % 3;
      inverse[j][i] = (m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1]) * scale;
    }
  }
  for (int j = 0; j < 3; ++j) {
    inverse[3][j] = -(m[3][0] * inverse[0][j] + m[3][1] * inverse[1][j] + m[3][2] * inverse[2][j]);
  }
  return inverse;
}

Mat4 linear_transpose(const Mat4& m) {
  Mat4 t;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) t[i][j] = m[j][i];
  }
  return t;
}

Vec3 apply_linear(const Vec3& v, const Mat4& m) {
  return Vec3(v.x * m[0][0] + v.y * m[1][0] + v.z * m[2][0], v.x * m[0][1] + v.y * m[1][1] + v.z * m[2][1],
              v.x * m[0][2] + v.y * m[1][2] + v.z * m[2][2]);
}

Vec3 apply(const Vec3& p, const Mat4& m) {
  return Vec3(p.x * m[0][0] + p.y * m[1][0] + p.z * m[2][0] + m[3][0],
              p.x * m[0][1] + p.y * m[1][1] + p.z * m[2][1] + m[3][1],
              p.x * m[0][2] + p.y * m[1][2] + p.z * m[2][2] + m[3][2]);
}

/// Turns by `radians` in the plane of two axes, from `from` towards `to`.
Mat4 turn(double radians, int from, int to) {
  Mat4 m;
  const double c = steady::cosine(radians);
  const double s = steady::sine(radians);
  m[from][from] = c;
  m[to][to] = c;
  m[from][to] = s;
  m[to][from] = -s;
  return m;
}

}  // namespace

Transform::Transform(const Matrices& matrices)
    : matrices_(matrices.forth == Mat4() ? Shared<Matrices>() : Shared<Matrices>(matrices)) {}

Transform::Transform(const Mat4& matrix) : Transform(Matrices{matrix, affine_inverse(matrix)}) {}

Transform Transform::translation(const Vec3& offset) {
  Matrices m;
  for (int axis = 0; axis < 3; ++axis) {
    m.forth[3][axis] = offset[axis];
    m.back[3][axis] = -offset[axis];
  }
  return Transform(m);
}

Transform Transform::rotation(const Vec3& degrees) {
  if (degrees == Vec3(0.0)) return Transform();
  const Vec3 r = degrees * kRadiansPerDegree;
  // In a left-handed system with row vectors: x turns y to z, y turns z to x, z turns x to y.
  const Mat4 matrix = turn(r.x, 1, 2) * turn(r.y, 2, 0) * turn(r.z, 0, 1);
  return Transform(Matrices{matrix, linear_transpose(matrix)});
}

Transform Transform::scaling(const Vec3& factors) {
  Matrices m;
  for (int axis = 0; axis < 3; ++axis) {
    m.forth[axis][axis] = factors[axis];
    m.back[axis][axis] = 1.0 / factors[axis];
  }
  return Transform(m);
}

Transform Transform::rotation_about(const Vec3& axis, double degrees) {
  return turning(axis, degrees * kRadiansPerDegree);
}

Transform Transform::turning(const Vec3& axis, double radians) {
  const Vec3 u = unit(axis);
  if (!(u.length2() > 0.0) || radians == 0.0) return Transform();
  const double c = steady::cosine(radians);
  const double s = steady::sine(radians);
  Mat4 matrix;
  // Rodrigues' rotation as a matrix for row vectors: u u^T (1 - c) + I c + [u]x^T s.
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      matrix[i][j] = i == j ? u[i] * u[i] + c * (1.0 - u[i] * u[i]) : u[i] * u[j] * (1.0 - c);
    }
    const int j1 = (i + 1) % 3;
    const int j2 = (i + 2) % 3;
    matrix[i][j1] += u[j2] * s;
    matrix[i][j2] -= u[j1] * s;
  }
  return Transform(Matrices{matrix, linear_transpose(matrix)});
}

bool Transform::is_invertible(const Mat4& matrix) {
  const double d = determinant3(matrix);
  if (d == 0.0 || !std::isfinite(d) || !std::isfinite(1.0 / d)) return false;
  const Mat4 inverse = affine_inverse(matrix);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (!std::isfinite(matrix[i][j]) || !std::isfinite(inverse[i][j])) return false;
    }
  }
  return matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
}

Transform Transform::inverse() const {
  return is_identity() ? Transform() : Transform(Matrices{matrices_->back, matrices_->forth});
}

Transform Transform::then(const Transform& next) const {
  if (is_identity()) return next;
  if (next.is_identity()) return *this;
  return Transform(Matrices{matrices_->forth * next.matrices_->forth, next.matrices_->back * matrices_->back});
}

Vec3 Transform::point(const Vec3& p) const { return is_identity() ? p : apply(p, matrices_->forth); }

Vec3 Transform::direction(const Vec3& d) const { return is_identity() ? d : apply_linear(d, matrices_->forth); }

Vec3 Transform::normal(const Vec3& n) const {
  if (is_identity()) return n;
  const Mat4& m = matrices_->back;
  return Vec3(n.x * m[0][0] + n.y * m[0][1] + n.z * m[0][2], n.x * m[1][0] + n.y * m[1][1] + n.z * m[1][2],
              n.x * m[2][0] + n.y * m[2][1] + n.z * m[2][2]);
}

Vec3 Transform::inverse_point(const Vec3& p) const { return is_identity() ? p : apply(p, matrices_->back); }

Vec3 Transform::inverse_direction(const Vec3& d) const { return is_identity() ? d : apply_linear(d, matrices_->back); }

Ray Transform::inverse_ray(const Ray& ray) const {
  return Ray{inverse_point(ray.origin), inverse_direction(ray.direction)};
}

Box3 Transform::box(const Box3& b) const {
  if (is_identity() || b.isEmpty()) return b;
  const Mat4& matrix = matrices_->forth;
  Box3 out;
  for (int axis = 0; axis < 3; ++axis) {
    double low = matrix[3][axis];
    double high = low;
    bool no_low = false;
    bool no_high = false;
    for (int from = 0; from < 3; ++from) {
      const double factor = matrix[from][axis];
      if (factor == 0.0) continue;
      const double lower = factor > 0.0 ? b.min[from] : b.max[from];
      const double upper = factor > 0.0 ? b.max[from] : b.min[from];
      no_low = no_low || std::abs(lower) >= kBoundless;
      no_high = no_high || std::abs(upper) >= kBoundless;
      low += factor * lower;
      high += factor * upper;
    }
    out.min[axis] = no_low ? -kBoundless : low;
    out.max[axis] = no_high ? kBoundless : high;
  }
  return out;
}

}  // namespace firstlight::render
