#include "render/lanes/math.h"
#include "render/light/arrival.h"

#include <cmath>

namespace firstlight::render {

/// The share is what is left of the falloff at a distance from the axis, to the power of `tightness`; from the radius
/// to the falloff it goes down to nothing. Nothing shines behind the light.
void beam::tube(const Light& light, const Columns3<double>& points, std::size_t count, Arrival& arrival) {
  const Vec3 axis = unit(light.point_at - light.position);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 way = points.vector(i) - light.position;
    const double along = way.dot(axis);
    const double distance = (way - axis * along).length();
    double share = 0.0;
    if (along > 0.0 && distance < light.falloff) {
      const double left = 1.0 - distance / light.falloff;
      share = light.tightness == 0.0 ? 1.0 : steady::power(left, light.tightness);
      if (light.radius > 0.0 && distance > light.radius) {
        share *= smooth_step(0.0, 1.0 - light.radius / light.falloff, left);
      }
    }
    arrival.share[i] = share;
  }
}

}  // namespace firstlight::render
