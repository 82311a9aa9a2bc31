#pragma once

#include "render/math/ray_columns.h"

#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// Up to kRaysAtOnce rays side by side; of each counts what lies between min_depth and max_depth, both excluded.
struct RayBlock : RayColumns {
  std::size_t size = 0;
  Column<double> min_depth;
  Column<double> max_depth;         ///< not beyond min_depth: the ray meets nothing
  Column<std::int64_t> hidden_bit;  ///< kHiddenFromPrimary, ...Reflection or ...Shadow of its kind; 0: sees all

  /// A bit for each ray.
  std::uint64_t all() const { return size == 0 ? 0 : ~std::uint64_t{0} >> (kRaysAtOnce - size); }
};

}  // namespace firstlight::render
