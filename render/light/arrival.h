#pragma once

#include "render/light/light.h"
#include "render/math/columns.h"

#include <cstddef>

namespace firstlight::render {

/// How a light comes to points, side by side. Plain data.
struct Arrival {
  Columns3<double> direction;  ///< as LightAim has it
  Column<double> depth;
  Column<double> share;  ///< of the light's colour: what the beam and the distance leave
};

/// Replaces `arrival` by that of `light` at the first `count` of `points`. `places`: where the light is for each of
/// them; null: at its position.
/// Source   POV-Ray 3.7 manual, "Light Source".
void arrive(const Light& light, const Columns3<double>& points, std::size_t count, const Columns3<double>* places,
            Arrival& arrival);

/// Whether a light comes to all points alike, but for what distance takes: then `share` is fading().
inline bool is_plain(const Light& light) { return light.kind == LightKind::point && !light.parallel; }

/// The beams of lights.def, a file each: they set `share`, and find the rest set.
namespace beam {
#define LIGHT(kind, shape, parallel, radius, falloff) \
  void shape(const Light& light, const Columns3<double>& points, std::size_t count, Arrival& arrival);
#include "render/light/lights.def"
#undef LIGHT

/// From 0 at `low` to 1 at `high` along 3t^2 - 2t^3.
inline double smooth_step(double low, double high, double x) {
  if (x < low) return 0.0;
  if (x >= high) return 1.0;
  const double t = (x - low) / (high - low);
  return (3.0 - 2.0 * t) * t * t;
}
}  // namespace beam

}  // namespace firstlight::render
