#pragma once

#include <atomic>
#include <bit>
#include <cstdint>

namespace firstlight::priority {

/// How much of a whole a part has been so far: learnt while rendering, by many threads, and asked for by all of them.
/// Old observations fade as new ones come.
///
/// Cost     a few instructions, no lock: of two observations made at the same instant one may be lost.
/// Memory   8 bytes.
class RunningRatio {
 public:
  /// Pre: both are finite and not negative.
  void add(float part, float whole) {
    const std::uint64_t seen = sums_.load(std::memory_order_relaxed);
    float parts = part_of(seen) + part;
    float wholes = whole_of(seen) + whole;
    if (wholes > kLongest) {
      parts *= 0.5f;
      wholes *= 0.5f;
    }
    sums_.store(std::uint64_t{std::bit_cast<std::uint32_t>(parts)} << 32 | std::bit_cast<std::uint32_t>(wholes),
                std::memory_order_relaxed);
  }
  /// The ratio, `before` being what was believed before anything was seen, as if from a whole of `trust`. Pre: trust >
  /// 0.
  float estimate(float before, float trust) const {
    const std::uint64_t seen = sums_.load(std::memory_order_relaxed);
    return (part_of(seen) + before * trust) / (whole_of(seen) + trust);
  }

 private:
  static constexpr float kLongest = 256.0f;
  static float part_of(std::uint64_t sums) { return std::bit_cast<float>(static_cast<std::uint32_t>(sums >> 32)); }
  static float whole_of(std::uint64_t sums) { return std::bit_cast<float>(static_cast<std::uint32_t>(sums)); }

  std::atomic<std::uint64_t> sums_ = 0;
};

}  // namespace firstlight::priority
