#pragma once

#include "render/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// How many rays are traced side by side: enough for the widest vectors, few enough for their numbers to stay in the
/// nearest cache.
constexpr std::size_t kRaysAtOnce = 64;

/// One number of each of kRaysAtOnce rays. Not cleared when made: a short block is not to pay for the whole column, and
/// what is computed from lanes beyond its end is not used.
template <class T>
struct alignas(64) Column {
  std::array<T, kRaysAtOnce> at;

  T& operator[](std::size_t i) { return at[i]; }
  const T& operator[](std::size_t i) const { return at[i]; }
};

template <class T>
struct Columns3 {
  std::array<Column<T>, 3> of;

  template <class Vector>
  void set(std::size_t i, const Vector& v) {
    of[0][i] = v.x;
    of[1][i] = v.y;
    of[2][i] = v.z;
  }
  Vec3 vector(std::size_t i) const { return {of[0][i], of[1][i], of[2][i]}; }
};

/// Up to kRaysAtOnce rays side by side; of each counts what lies between min_depth and max_depth, both excluded.
struct RayBlock {
  std::size_t size = 0;
  Columns3<double> origin;
  Columns3<double> direction;
  Column<double> min_depth;
  Column<double> max_depth;         ///< not beyond min_depth: the ray meets nothing
  Column<std::int64_t> hidden_bit;  ///< kHiddenFromPrimary, ...Reflection or ...Shadow of its kind; 0: sees everything

  /// A bit for each ray.
  std::uint64_t all() const { return size == 0 ? 0 : ~std::uint64_t{0} >> (kRaysAtOnce - size); }
};

}  // namespace firstlight::render
