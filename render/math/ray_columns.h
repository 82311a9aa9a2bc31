#pragma once

#include "render/math/columns.h"
#include "render/math/vec.h"

#include <cstddef>

namespace firstlight::render {

/// Up to kRaysAtOnce rays side by side.
struct RayColumns {
  Columns3<double> origin;
  Columns3<double> direction;

  Ray ray(std::size_t i) const { return {origin.vector(i), direction.vector(i)}; }
};

/// Several rays; crossings beyond `low` and not beyond `high` count.
struct DepthWindow {
  const Column<double>& low;
  const Column<double>& high;
};

}  // namespace firstlight::render
