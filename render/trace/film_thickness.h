#pragma once

#include "render/math/noise.h"
#include "render/texture/finish.h"

namespace firstlight::render {

/// Thickness of the film on a layer, which its turbulence makes uneven.
inline double film_thickness(const Finish& finish, const Vec3& point, int noise_generator) {
  if (finish.irid_turbulence == 0.0) return finish.irid_thickness;
  const double noise = turbulence(point, {5, 2.0f, 0.5f}, noise_generator);
  return finish.irid_thickness * (1.0 + (2.0 * noise - 1.0) * finish.irid_turbulence);
}

}  // namespace firstlight::render
