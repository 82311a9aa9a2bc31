#pragma once

#include "render/math/color.h"
#include "render/math/transform.h"
#include "render/math/vec.h"
#include "render/feature/feature.h"

#include <cmath>

namespace firstlight::render {

/// A point light. Plain data.
/// Source   POV-Ray 3.7 manual, "Light Source".
struct Light {
  Vec3 position{0.0, 0.0, 0.0};
  Rgb color{1.0f, 1.0f, 1.0f};
  bool shadowless = false;     ///< lights without being blocked, and gives no highlights
  double fade_distance = 0.0;  ///< scene units
  double fade_power = 0.0;     ///< 0: no fading
  FeatureUses unrendered = {};
};

/// Whether the light is weaker far away.
inline bool fades(const Light& light) {
  constexpr double kShortestFade = 1e-10;
  return light.fade_power > 0.0 && std::abs(light.fade_distance) > kShortestFade;
}

/// Share of the full light at a distance: 2 / (1 + (d / fade_distance)^fade_power), at most twice the full light.
/// [POV-Ray 3.7 manual, "Light Fading"]
inline double fading(const Light& light, double distance) {
  if (!fades(light)) return 1.0;
  return 2.0 / (1.0 + std::pow(distance / light.fade_distance, light.fade_power));
}

Light placed(const Light& light, const Transform& transform);

}  // namespace firstlight::render
