#pragma once

#include "render/math/ray_columns.h"
#include "render/math/transform.h"
#include "render/math/vec.h"

#include <cmath>
#include <cstdint>
#include <variant>

namespace firstlight::render {

struct ContainerBox {
  Vec3 low{-1.0, -1.0, -1.0};
  Vec3 high{1.0, 1.0, 1.0};
};
struct ContainerSphere {
  Vec3 center{0.0, 0.0, 0.0};
  double radius = 1.0;
};
/// Where a surface that is given by functions is looked for.
using Container = std::variant<ContainerBox, ContainerSphere>;

/// Rays of a block in the space of a container, and the parts of them in it. Face 0 is a sphere; a box has 1 + those of
/// AxisBox. Depths are those of the given rays, whatever their directions' lengths. [POV-Ray 3.7]
struct ContainedRays {
  RayColumns rays;
  std::uint64_t met = 0;  ///< bits of those that pass through the container; of others there is no part
  Column<double> begin;   ///< of a ray that starts in a box 0, in a sphere below 0
  Column<double> end;
  Column<double> begin_face, end_face;

  /// Those in `who` of `given`; `transform` leads from the container's space into theirs.
  ContainedRays(const Container& container, const Transform& transform, const RayColumns& given, std::uint64_t who);
};

/// Returns the bits of those points in `who` that are in the container; `own` gets the points in its space.
std::uint64_t held_points(const Container& container, const Transform& transform, const Columns3<double>& points,
                          std::uint64_t who, Columns3<double>& own);

inline Box3 bounds_of(const Container& container) {
  if (const auto* sphere = std::get_if<ContainerSphere>(&container)) {
    const Vec3 reach(std::abs(sphere->radius));
    return Box3(sphere->center - reach, sphere->center + reach);
  }
  const auto& box = std::get<ContainerBox>(container);
  return Box3(box.low, box.high);
}

}  // namespace firstlight::render
