#pragma once

#include <cstdint>

namespace firstlight::priority {

/// Priority of a waiting ray: in [0, kBuckets); a larger key leaves first, equal keys are interchangeable.
using Key = std::uint32_t;

/// Enough for the exponent and the four leading mantissa bits of any positive float.
constexpr Key kBuckets = 4096;

}  // namespace firstlight::priority
