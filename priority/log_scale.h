#pragma once

#include "priority/key.h"

#include <bit>
#include <cstdint>

namespace firstlight::priority {

/// Keys that grow with the logarithm of a number: equal ratios are equal distances. What is too small or too large for
/// the scale, zero, negative numbers and not-a-number get its ends.
class LogScale {
 public:
  /// From 2^lowest to 2^highest with `1 << step_bits` keys to an octave.
  constexpr LogScale(int lowest, int highest, int step_bits)
      : shift_(kMantissaBits - step_bits),
        first_(static_cast<std::int32_t>((kBias + lowest) << step_bits)),
        count_(static_cast<std::int32_t>((highest - lowest) << step_bits)) {}

  constexpr Key count() const { return static_cast<Key>(count_); }
  constexpr Key of(float number) const {
    // The bits of a positive float grow with its size: the exponent and the leading bits of the mantissa are a
    // logarithm. Those of a negative one are a negative integer.
    const std::int32_t step = (std::bit_cast<std::int32_t>(number) >> shift_) - first_;
    return static_cast<Key>(step < 0 ? 0 : step >= count_ ? count_ - 1 : step);
  }

 private:
  static constexpr int kMantissaBits = 23;
  static constexpr int kBias = 127;
  int shift_;
  std::int32_t first_;
  std::int32_t count_;
};

}  // namespace firstlight::priority
