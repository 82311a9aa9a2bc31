#pragma once

#include "render/math/color.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>

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
    bits_ = rounded(color.x * scale) | rounded(color.y * scale) << kMantissaBits |
            rounded(color.z * scale) << (2 * kMantissaBits) | std::uint64_t{exponent} << (3 * kMantissaBits);
  }

  /// Pre: `bits` came from bits(), or are laid out as the members below have it.
  static PackedRgb from_bits(std::uint64_t bits) {
    PackedRgb packed;
    packed.bits_ = bits;
    return packed;
  }
  /// 0 for black and for nothing else.
  std::uint64_t bits() const { return bits_; }

  Rgb unpack() const {
    const std::uint32_t exponent = biased_exponent();
    if (exponent == 0) return Rgb(0.0f);
    const float step = power_of_two(exponent + 1 - (kMantissaBits - 1));
    return {static_cast<float>(mantissa(0)) * step, static_cast<float>(mantissa(1)) * step,
            static_cast<float>(mantissa(2)) * step};
  }

  /// |r| + |g| + |b|. Pre: not black.
  float sum_of_magnitudes() const {
    const std::int64_t sum = std::abs(mantissa(0)) + std::abs(mantissa(1)) + std::abs(mantissa(2));
    return static_cast<float>(static_cast<std::int32_t>(sum)) *
           power_of_two(biased_exponent() + 1 - (kMantissaBits - 1));
  }

  /// Component = mantissa * 2^(biased_exponent() - kExponentOfOne). Pre: index < 3.
  std::int64_t mantissa(std::uint32_t index) const {
    constexpr std::uint32_t kUnused = 64 - kMantissaBits;
    return static_cast<std::int64_t>(bits_ << (kUnused - index * kMantissaBits)) >> kUnused;
  }
  std::uint32_t biased_exponent() const { return static_cast<std::uint32_t>(bits_ >> (3 * kMantissaBits)); }
  static constexpr int kExponentOfOne = 143;

  static constexpr std::uint32_t kBias = 127;  ///< of a float's exponent
  static constexpr std::uint32_t kMantissaBits = 18;
  static constexpr std::uint32_t kSmallest = 17;  ///< biased exponent below which a colour is black
  static constexpr float kLargestMantissa = 131071.0f;

 private:
  static float power_of_two(std::uint32_t biased) { return std::bit_cast<float>(biased << 23); }
  static std::uint64_t rounded(float scaled) {
    const float away = std::clamp(scaled, -kLargestMantissa, kLargestMantissa) + std::copysign(0.5f, scaled);
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(away)) & ((1u << kMantissaBits) - 1);
  }
  std::uint64_t bits_ = 0;  // mantissas from the lowest bit on, then the exponent
};

}  // namespace firstlight::render
