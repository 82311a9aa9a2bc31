#pragma once

#include "render/trace/ray_kind.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// Rays that are done, by kind.
struct RayCounts {
  std::array<std::uint64_t, kRayKinds> by_kind{};  ///< indexed by RayKind
  // Feelers that are known by their direction, so they are not traced:
  std::uint64_t clear = 0;
  std::uint64_t blocked = 0;

  std::uint64_t& of(RayKind kind) { return by_kind[static_cast<std::size_t>(kind)]; }
  std::uint64_t of(RayKind kind) const { return by_kind[static_cast<std::size_t>(kind)]; }
  std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t count : by_kind) sum += count;
    return sum;
  }
  std::uint64_t traced() const { return total() - clear - blocked; }
  RayCounts& operator+=(const RayCounts& other);
  RayCounts operator-(const RayCounts& before) const;
};

}  // namespace firstlight::render
