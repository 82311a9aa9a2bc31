#pragma once

#include "render/math/color.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace firstlight::render {

/// A colour in 8 bytes: three signed mantissas of 18 bits that share the exponent of the largest component, so each is
/// within 2^-17 of that component. What is unpacked packs to the same bits.
class PackedRgb {
 public:
  PackedRgb() = default;
  /// Not-a-number and infinity become black, as does what is smaller than 2^-110.
  explicit PackedRgb(const Rgb& color) {
    const std::uint32_t exponent = std::bit_cast<std::uint32_t>(max_magnitude(color)) >> 23 & 0xffu;
    if (exponent < kSmallest || exponent == 0xffu) return;
    const float scale = power_of_two(kBias + kMantissaBits - 1 - (exponent - kBias + 1));
    bits_ = mantissa(color.x * scale) | mantissa(color.y * scale) << kMantissaBits |
            mantissa(color.z * scale) << (2 * kMantissaBits) | std::uint64_t{exponent} << (3 * kMantissaBits);
  }

  Rgb unpack() const {
    const auto exponent = static_cast<std::uint32_t>(bits_ >> (3 * kMantissaBits));
    if (exponent == 0) return Rgb(0.0f);
    const float step = power_of_two(exponent + 1 - (kMantissaBits - 1));
    return {component(0) * step, component(1) * step, component(2) * step};
  }

 private:
  static constexpr std::uint32_t kBias = 127;  // of a float's exponent
  static constexpr std::uint32_t kMantissaBits = 18;
  static constexpr std::uint32_t kSmallest = 17;
  static constexpr float kLargestMantissa = 131071.0f;

  static float power_of_two(std::uint32_t biased) { return std::bit_cast<float>(biased << 23); }
  static std::uint64_t mantissa(float scaled) {
    const auto rounded = static_cast<std::int32_t>(std::lrint(std::clamp(scaled, -kLargestMantissa, kLargestMantissa)));
    return static_cast<std::uint32_t>(rounded) & ((1u << kMantissaBits) - 1);
  }
  float component(std::uint32_t index) const {
    constexpr std::uint32_t kUnused = 64 - kMantissaBits;
    const auto top = static_cast<std::int64_t>(bits_ << (kUnused - index * kMantissaBits));
    return static_cast<float>(top >> kUnused);
  }

  std::uint64_t bits_ = 0;
};

}  // namespace firstlight::render
