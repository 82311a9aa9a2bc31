#include "render/shape/sweep_segment.h"

#include "render/math/polynomial.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace firstlight::render {
namespace {

// Limits below which POV-Ray takes numbers for 0 here: a leading coefficient or a discriminant, and a slope.
constexpr double kSmall = 1e-10;
constexpr double kRightAngle = 1e-4;

/// The product of two polynomials, c[k] x^k.
template <std::size_t N, std::size_t M>
std::array<double, N + M - 1> operator*(const std::array<double, N>& a, const std::array<double, M>& b) {
  std::array<double, N + M - 1> product{};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = 0; k < M; ++k) product[i + k] += a[i] * b[k];
  }
  return product;
}
template <std::size_t N>
std::array<double, N> operator+(std::array<double, N> a, const std::array<double, N>& b) {
  for (std::size_t i = 0; i < N; ++i) a[i] += b[i];
  return a;
}
template <std::size_t N>
std::array<double, N - 1> derivative(const std::array<double, N>& a) {
  std::array<double, N - 1> d;
  for (std::size_t i = 1; i < N; ++i) d[i - 1] = static_cast<double>(i) * a[i];
  return d;
}

/// The Bernstein coefficients of c on [0, 1] all on one side of 0: then there is no root between. A chance that is
/// missed costs time only.
template <std::size_t N>
bool has_no_root(const std::array<double, N>& c) {
  static const auto binomial = [] {
    std::array<std::array<double, N>, N> table{};
    for (std::size_t n = 0; n < N; ++n) {
      table[n][0] = 1.0;
      for (std::size_t k = 1; k <= n; ++k) table[n][k] = table[n - 1][k - 1] + (k < n ? table[n - 1][k] : 0.0);
    }
    return table;
  }();
  // b[i] = sum over k up to i of binomial(i, k) / binomial(order, k) c[k], by differences.
  std::array<double, N> b;
  for (std::size_t k = 0; k < N; ++k) b[k] = c[k] / binomial[N - 1][k];
  bool above = true;
  bool below = true;
  for (std::size_t i = 0; i < N; ++i) {
    above = above && b[0] >= 0.0;
    below = below && b[0] <= 0.0;
    if (!above && !below) return false;
    for (std::size_t k = 0; k + 1 < N - i; ++k) b[k] += b[k + 1];
  }
  return true;
}

/// In [0, 1], of a polynomial of order 2 by POV-Ray's rule, which keeps the middle where two roots are one.
std::size_t quadratic_roots(double a, double b, double c, std::span<double> roots) {
  std::size_t count = 0;
  const auto add = [&](double x) {
    if (x >= 0.0 && x <= 1.0) roots[count++] = x;
  };
  if (std::abs(a) < kSmall) {
    if (std::abs(b) >= kSmall) add(-c / b);
    return count;
  }
  b /= -a;
  c /= a;
  const double discriminant = b * b - 4.0 * c;
  if (std::abs(discriminant) < kSmall) {
    add(0.5 * b);
  } else if (discriminant > 0.0) {
    add(0.5 * (b + std::sqrt(discriminant)));
    add(0.5 * (b - std::sqrt(discriminant)));
  }
  return count;
}

/// The powers of u in product(ball(u) - at, ball(u) - at): the square of the distance to the ball's surface, as it were.
std::array<double, 7> distance(const SweepSegment& segment, const Vec3& at) {
  std::array<SweepBall, 4> c = segment.coefficients;
  c[0].center -= at;
  std::array<double, 7> sum{};
  for (std::size_t i = 0; i <= segment.order; ++i) {
    for (std::size_t k = 0; k <= segment.order; ++k) sum[i + k] += product(c[i], c[k]);
  }
  return sum;
}

}  // namespace

Box3 SweepSegment::bounds() const {
  // Bezier's points of the curve: it stays between them, and so do its radii.
  std::array<SweepBall, 4> points = coefficients;
  const auto& c = coefficients;
  if (order == 1) {
    points[1] = c[0] + c[1];
  } else {
    points[1] = c[0] + c[1] * (1.0 / 3.0);
    points[2] = c[0] + c[1] * (2.0 / 3.0) + c[2] * (1.0 / 3.0);
    points[3] = c[0] + c[1] + c[2] + c[3];
  }
  Box3 box;
  for (std::size_t i = 0; i <= order; ++i) {
    const Vec3 reach(points[i].radius);
    box.extendBy(points[i].center - reach);
    box.extendBy(points[i].center + reach);
  }
  return box;
}

std::size_t SweepSegment::touching(const Ray& ray, std::array<double, kMostRoots>& u) const {
  // The square of the distance is t^2 + B(u) t + D(u), with unit direction; its derivative by u is B' t + D'. With the t of
  // the second in the first: D'^2 - B B' D' + B'^2 D = 0.
  std::array<double, 7> d = distance(*this, ray.origin);
  std::array<double, 4> b{};
  for (std::size_t i = 0; i <= order; ++i) b[i] = -2.0 * coefficients[i].center.dot(ray.direction);
  b[0] += 2.0 * ray.origin.dot(ray.direction);
  if (order == 1) {
    const double b2 = b[1] * b[1];
    return quadratic_roots(4.0 * d[2] * d[2] - b2 * d[2], 4.0 * d[2] * d[1] - 2.0 * b[1] * b[0] * d[2],
                           d[1] * d[1] - b[1] * b[0] * d[1] + b2 * d[0], u);
  }
  const std::array<double, 6> d1 = derivative(d);
  std::array<double, 3> b1 = derivative(b);
  const std::array<double, 5> b1b1 = b1 * b1;
  for (double& c : b1) c = -c;
  const std::array<double, 11> equation = d1 * d1 + (b * b1) * d1 + b1b1 * d;
  if (has_no_root(equation)) return 0;
  std::size_t count = 0;
  for (PolynomialRoots roots(equation, 0.0, 1.0); count < u.size() && roots.next(u[count]);) ++count;
  return count;
}

bool SweepSegment::straight_depth(const Ray& ray, double u, double& depth) const {
  const double b = -2.0 * coefficients[1].center.dot(ray.direction);
  if (!(std::abs(b) > kRightAngle)) return false;
  const std::array<double, 7> d = distance(*this, ray.origin);
  depth = -(2.0 * d[2] * u + d[1]) / b;
  return true;
}

bool SweepSegment::holds(const Vec3& point) const {
  const std::array<double, 7> d = distance(*this, point);
  std::array<double, 6> roots;
  if (order == 1) return quadratic_roots(d[2], d[1], d[0], roots) > 0;
  return !has_no_root(d) && PolynomialRoots(d, 0.0, 1.0).next(roots[0]);
}

}  // namespace firstlight::render
