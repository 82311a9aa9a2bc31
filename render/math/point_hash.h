#pragma once

#include "render/math/vec.h"

#include <bit>
#include <cstdint>

namespace firstlight::render {

/// A number in [0, 1) that looks random and hangs on nothing but its arguments: chance that belongs to a place and not to
/// the order in which places are come to. `salt` tells apart what is drawn for one place.
/// Source   Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators": the mixing of SplitMix64.
inline double hashed_number(const Vec3& place, std::uint64_t salt) {
  const auto mix = [](std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  };
  constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;
  std::uint64_t state = mix(salt + kStep);
  for (const double coordinate : {place.x, place.y, place.z}) {
    state = mix((state ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) + kStep);
  }
  return static_cast<double>(state >> 11) * 0x1p-53;
}

}  // namespace firstlight::render
