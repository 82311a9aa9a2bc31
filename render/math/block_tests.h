#pragma once

#include "render/math/bounds.h"
#include "render/math/ray_columns.h"

#include <cstdint>

namespace firstlight::render {

// Tests of rays or points side by side. `who` has the bits of those that are asked for; what is returned, the bits of
// those of them for which it holds.

/// Whether rays pass through the box in front of their origins. As meets() of one ray, but `inverse` has one over each
/// direction, for 0 a number that is large and finite: so test padded boxes.
std::uint64_t meeting(const RayColumns& rays, const Columns3<double>& inverse, const Box3& box, std::uint64_t who);
/// Whether points lie in the box or on its faces.
std::uint64_t within(const Columns3<double>& points, const Box3& box, std::uint64_t who);
/// Where the rays are at `depth`.
void points_along(const RayColumns& rays, const Column<double>& depth, std::uint64_t who, Columns3<double>& points);

}  // namespace firstlight::render
