#pragma once

#include "render/math/columns.h"
#include "render/scene/atmosphere.h"

#include <cstddef>

namespace firstlight::render {

// The share of the light that is left after a way through a fog: from the origin of a ray, whose direction has unit
// length, to `depth`. [POV-Ray 3.7 manual, "Fog"]

/// Finds it for the first `count` rays.
void find_fog_shares(const Fog& fog, int noise_generator, std::size_t count, const Columns3<double>& origin,
                     const Columns3<double>& direction, const Column<double>& depth, Column<double>& share);
double fog_share(const Fog& fog, int noise_generator, const Ray& ray, double depth);

}  // namespace firstlight::render
