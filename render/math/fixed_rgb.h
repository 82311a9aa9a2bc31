#pragma once

#include "render/math/color.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace firstlight::render {

/// A colour in fixed point, 2^-36 a step: adding is exact, so the order of adding does not show.
struct FixedRgb {
  std::int64_t r = 0;
  std::int64_t g = 0;
  std::int64_t b = 0;

  /// Rounds to the nearest step; components beyond 2^24 in size are cut there, not-a-number is 0.
  static FixedRgb from(const Rgb& color) { return {to_fixed(color.x), to_fixed(color.y), to_fixed(color.z)}; }
  Rgb to_rgb() const { return {to_float(r), to_float(g), to_float(b)}; }

  FixedRgb& operator+=(const FixedRgb& other) {
    r = sum(r, other.r);
    g = sum(g, other.g);
    b = sum(b, other.b);
    return *this;
  }
  bool operator==(const FixedRgb&) const = default;
  /// Wraps instead of overflowing, so that even absurd scenes end in the same picture in any order.
  static std::int64_t sum(std::int64_t a, std::int64_t b) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
  }

 private:
  static constexpr double kStepsPerUnit = 68719476736.0;  // 2^36
  static constexpr double kLimit = 16777216.0;            // 2^24

  static std::int64_t to_fixed(float value) {
    if (std::isnan(value)) return 0;
    return std::llrint(std::clamp(static_cast<double>(value), -kLimit, kLimit) * kStepsPerUnit);
  }
  static float to_float(std::int64_t steps) { return static_cast<float>(static_cast<double>(steps) / kStepsPerUnit); }
};

/// Light to be added to a sample; negative where feelers take light back.
struct Contribution {
  std::uint32_t sample = 0;
  FixedRgb light;
};

}  // namespace firstlight::render
