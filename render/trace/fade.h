#pragma once

#include "render/lanes/math.h"
#include "render/math/color.h"
#include "render/texture/interior.h"

#include <cmath>

namespace firstlight::render {

/// Light left after `depth` scene units inside the matter.
/// Source   POV-Ray 3.7: c + (1 - c) / (1 + (d / fade_distance)^fade_power); from power 1000 on exp(-(1 - c) d /
/// fade_distance).
inline Rgb faded_light(const Interior& interior, double depth) {
  constexpr double kExponentialPower = 1000.0;
  const double distance = depth / interior.fade_distance;
  const Rgb lost = Rgb(1.0f) - interior.fade_color;
  if (interior.fade_power >= kExponentialPower) {
    return {static_cast<float>(steady::exponential(-lost.x * distance)),
            static_cast<float>(steady::exponential(-lost.y * distance)),
            static_cast<float>(steady::exponential(-lost.z * distance))};
  }
  return interior.fade_color + lost * static_cast<float>(1.0 / (1.0 + steady::power(distance, interior.fade_power)));
}

}  // namespace firstlight::render
