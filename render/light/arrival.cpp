#include "render/light/arrival.h"

#include <array>

namespace firstlight::render {
namespace {

using Beam = void (*)(const Light&, const Columns3<double>&, std::size_t, Arrival&);

constexpr auto kBeams = std::to_array<Beam>({
#define LIGHT(kind, shape, parallel, radius, falloff) beam::shape,
#include "render/light/lights.def"
#undef LIGHT
});

}  // namespace

void arrive(const Light& light, const Columns3<double>& points, std::size_t count, const Columns3<double>* places,
            Arrival& arrival) {
  for (std::size_t i = 0; i < count; ++i) {
    const LightAim aim = aim_at(light, places != nullptr ? places->vector(i) : light.position, points.vector(i));
    arrival.direction.set(i, aim.direction);
    arrival.depth[i] = aim.depth;
  }
  kBeams[static_cast<std::size_t>(light.kind)](light, points, count, arrival);
  if (!fades(light)) return;
  for (std::size_t i = 0; i < count; ++i) {
    if (arrival.share[i] > 0.0) arrival.share[i] *= fading(light, arrival.depth[i]);
  }
}

}  // namespace firstlight::render
