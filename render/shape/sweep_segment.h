#pragma once

#include "render/math/vec.h"
#include "render/shape/sphere_sweep.h"

#include <array>
#include <cstddef>

namespace firstlight::render {

/// A ball of a sweep: the place of its middle, and its radius.
using SweepBall = SphereSweepParameters::Ball;

inline SweepBall operator+(const SweepBall& a, const SweepBall& b) { return {a.center + b.center, a.radius + b.radius}; }
inline SweepBall operator*(const SweepBall& a, double f) { return {a.center * f, a.radius * f}; }
/// The product in which a ball that holds the origin on its surface is 0: x x' + y y' + z z' - r r'.
inline double product(const SweepBall& a, const SweepBall& b) { return a.center.dot(b.center) - a.radius * b.radius; }

/// A piece of a sweep: the ball at u from 0 to 1 is coefficients[0] + coefficients[1] u + ... Balls and their radii are
/// one curve in a space of four dimensions.
struct SweepSegment {
  static constexpr std::size_t kMostRoots = 10;

  std::array<SweepBall, 4> coefficients;
  std::size_t order;  ///< 1 or 3

  SweepBall ball(double u) const {
    SweepBall sum = coefficients[order];
    for (std::size_t i = order; i-- > 0;) sum = sum * u + coefficients[i];
    return sum;
  }
  /// d ball / du
  SweepBall slope(double u) const {
    SweepBall sum = coefficients[order] * static_cast<double>(order);
    for (std::size_t i = order; i-- > 1;) sum = sum * u + coefficients[i] * static_cast<double>(i);
    return sum;
  }
  /// A box around all its balls.
  Box3 bounds() const;

  /// Where on the curve the ball's surface touches the whole's on the ray, whose direction is of unit length: at a depth t
  /// and a u of the ray's point p(t) = |p(t) - center(u)|^2 - radius(u)^2 = 0 = its derivative by u. Returns how many.
  std::size_t touching(const Ray& ray, std::array<double, kMostRoots>& u) const;
  /// At such a u of a straight segment, the depth; false where the ray meets it at a right angle.
  bool straight_depth(const Ray& ray, double u, double& depth) const;
  /// Whether the point is in any of its balls.
  bool holds(const Vec3& point) const;
};

}  // namespace firstlight::render
