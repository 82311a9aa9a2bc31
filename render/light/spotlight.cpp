#include "render/lanes/math.h"
#include "render/light/arrival.h"

#include <cmath>
#include <numbers>

namespace firstlight::render {

/// The cosine to the axis, to the power of `tightness`; from the radius to the falloff it goes down to nothing. Rays
/// that are all parallel are all along the axis.
void beam::cone(const Light& light, const Columns3<double>&, std::size_t count, Arrival& arrival) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  const Vec3 axis = unit(light.point_at - light.position);
  const double radius = steady::cosine(light.radius * kDegree);
  const double falloff = steady::cosine(light.falloff * kDegree);
  for (std::size_t i = 0; i < count; ++i) {
    const double backwards = arrival.direction.vector(i).dot(axis);
    const double cosine = arrival.depth[i] > 0.0 ? -backwards : backwards;
    double share = 0.0;
    if (cosine > 0.0) {
      share = light.tightness == 0.0 ? 1.0 : steady::power(cosine, light.tightness);
      if (radius > 0.0 && cosine < radius) share *= smooth_step(falloff, radius, cosine);
    }
    arrival.share[i] = share;
  }
}

}  // namespace firstlight::render
