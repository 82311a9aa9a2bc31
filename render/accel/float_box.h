#pragma once

#include "render/math/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace firstlight::render {

/// An axis-aligned box in float. Without end where a coordinate is beyond kLargestCoordinate.
struct FloatBox {
  static constexpr double kLargestCoordinate = 1e15;
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();

  float low[3] = {kInfinity, kInfinity, kInfinity};
  float high[3] = {-kInfinity, -kInfinity, -kInfinity};

  FloatBox() = default;
  /// The smallest that holds `box`.
  explicit FloatBox(const Box3& box) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = rounded_down(box.min[axis]);
      high[axis] = -rounded_down(-box.max[axis]);
    }
  }

  void extend(const FloatBox& other) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
  }

 private:
  static float rounded_down(double v) {
    if (!(v >= -kLargestCoordinate)) return -kInfinity;
    if (v > kLargestCoordinate) return static_cast<float>(kLargestCoordinate);
    const float f = static_cast<float>(v);
    return static_cast<double>(f) > v ? std::nextafter(f, -kInfinity) : f;
  }
};

}  // namespace firstlight::render
