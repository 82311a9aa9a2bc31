#pragma once

#include "render/math/vec.h"
#include "render/shape/sphere_sweep.h"

#include <array>
#include <cstddef>

namespace firstlight::render {

/// A ball of a sweep: the place of its middle, and its radius.
using SweepBall = SphereSweepParameters::Ball;

inline SweepBall operator+(const SweepBall& a, const SweepBall& b) {
  return {a.center + b.center, a.radius + b.radius};
}
inline SweepBall operator*(const SweepBall& a, double f) { return {a.center * f, a.radius * f}; }

/// A piece of a sweep: the ball at u from 0 to 1 is coefficients[0] + coefficients[1] u + ... Balls and their radii are
/// one curve in a space of four dimensions.
struct SweepSegment {
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
};

}  // namespace firstlight::render
