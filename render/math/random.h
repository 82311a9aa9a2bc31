#pragma once

#include "render/math/vec.h"

#include <bit>
#include <cstdint>

namespace firstlight::render {

/// Numbers that look drawn at random and are hashes of what they are drawn for, so that no stream of them has an order.
///
/// Source   Steele, Lea & Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014: its last step, by which
///          each bit that goes in changes half of those that come out.
class HashedDraws {
 public:
  /// Draws for a point, and another point or none.
  explicit HashedDraws(const Vec3& point, const Vec3& other = Vec3(0.0)) {
    for (const double number : {point.x, point.y, point.z, other.x, other.y, other.z}) {
      state_ = mixed(state_ + std::bit_cast<std::uint64_t>(number + 0.0));  // 0 and -0 are one point
    }
  }

  /// The draw of that number, in [0, 1).
  double operator[](std::uint64_t number) const { return static_cast<double>(mixed(state_ + number) >> 11) * 0x1p-53; }

 private:
  static std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
  }

  std::uint64_t state_ = 0;
};

}  // namespace firstlight::render
