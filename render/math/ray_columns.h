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

/// A ray that is asked for alone, in place 0.
inline RayColumns alone(const Ray& ray) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  return {{alone(o.x), alone(o.y), alone(o.z)}, {alone(d.x), alone(d.y), alone(d.z)}};
}

/// Several rays; crossings beyond `low` and not beyond `high` count.
struct DepthWindow {
  const Column<double>& low;
  const Column<double>& high;
};

}  // namespace firstlight::render
