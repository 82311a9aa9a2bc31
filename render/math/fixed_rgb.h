#pragma once

#include "render/math/color.h"
#include "render/math/packed_rgb.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace firstlight::render {

/// A colour in fixed point, 2^-36 a step: adding is exact, so the order of adding does not show.
struct FixedRgb {
  std::int64_t r = 0;
  std::int64_t g = 0;
  std::int64_t b = 0;

  /// Rounds to the nearest step; components beyond 2^24 in size are cut there, not-a-number is 0.
  static FixedRgb from(const Rgb& color) { return {to_fixed(color.x), to_fixed(color.y), to_fixed(color.z)}; }
  /// The same colour however often it is asked for, so that what was added can be taken away again to the last bit.
  static FixedRgb from(const PackedRgb& color) {
    const int shift = static_cast<int>(color.biased_exponent()) - PackedRgb::kExponentOfOne + kStepBits;
    if (shift > kLargestShift) return from(color.unpack());
    return {shifted(color.mantissa(0), shift), shifted(color.mantissa(1), shift), shifted(color.mantissa(2), shift)};
  }
  Rgb to_rgb() const { return {to_float(r), to_float(g), to_float(b)}; }

  FixedRgb& operator+=(const FixedRgb& other) {
    r = sum(r, other.r);
    g = sum(g, other.g);
    b = sum(b, other.b);
    return *this;
  }
  FixedRgb& operator-=(const FixedRgb& other) { return *this += {-other.r, -other.g, -other.b}; }
  /// The largest channel in size.
  std::int64_t max_magnitude() const { return std::max({std::abs(r), std::abs(g), std::abs(b)}); }
  bool operator==(const FixedRgb&) const = default;
  /// Wraps instead of overflowing, so that even absurd scenes end in the same picture in any order.
  static std::int64_t sum(std::int64_t a, std::int64_t b) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
  }
  /// One channel's steps as a number, white being 1.
  static double to_double(std::int64_t steps) { return static_cast<double>(steps) / kStepsPerUnit; }
  /// One channel's value in steps, as from() has it.
  static std::int64_t to_fixed(float value) {
    if (!(std::abs(value) <= kLimit)) return std::isnan(value) ? 0 : to_fixed(std::copysign(kLimit, value));
    const double steps = static_cast<double>(value) * kStepsPerUnit;
    return static_cast<std::int64_t>(steps + std::copysign(0.5, steps));
  }

  static constexpr int kStepBits = 36;
  static constexpr double kStepsPerUnit = 68719476736.0;  ///< 2^36
  static constexpr float kLimit = 16777216.0f;            ///< 2^24
  static constexpr int kLargestShift = 42;                ///< a mantissa of 18 bits stays below the limit

 private:
  /// mantissa * 2^shift, rounded.
  static std::int64_t shifted(std::int64_t mantissa, int shift) {
    if (shift >= 0) return mantissa * (std::int64_t{1} << shift);
    if (shift < -kLargestShift) return 0;
    return (mantissa + (std::int64_t{1} << (-shift - 1))) >> -shift;
  }
  static float to_float(std::int64_t steps) { return static_cast<float>(to_double(steps)); }
};

/// Light to be added to a sample; negative where feelers take light back.
struct Contribution {
  std::uint32_t sample = 0;
  FixedRgb light;
  /// Change, in the steps of FixedRgb, of the most that rays still to be traced can change any channel of the sample.
  std::int64_t outstanding = 0;
};

/// A share of what is behind the scene that shows through a sample, to be added to it: in the steps of FixedRgb.
struct Clearness {
  std::uint32_t sample = 0;
  std::int64_t steps = 0;
};

}  // namespace firstlight::render
