#pragma once

#include "render/math/color.h"
#include "render/math/transform.h"
#include "render/math/vec.h"

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
};

/// Light that arrives at a point, were nothing in the way.
struct Illumination {
  Vec3 direction;  ///< unit, from the point to the light
  double distance = 0.0;
  Rgb color;
};

/// Share of the full light at a distance: 2 / (1 + (d / fade_distance)^fade_power), at most twice the full light.
/// [POV-Ray 3.7 manual, "Light Fading"]
inline double fading(const Light& light, double distance) {
  constexpr double kShortestFade = 1e-10;
  if (!(light.fade_power > 0.0) || std::abs(light.fade_distance) <= kShortestFade) return 1.0;
  return 2.0 / (1.0 + std::pow(distance / light.fade_distance, light.fade_power));
}

/// In the light itself no direction leads to it; the zero vector stands for that, and gives no light.
inline Illumination illuminate(const Light& light, const Vec3& point) {
  const Vec3 way = light.position - point;
  const double distance = way.length();
  Illumination result{way, distance, light.color};
  if (distance > 0.0) result.direction *= 1.0 / distance;
  if (const double share = fading(light, distance); share != 1.0) result.color *= static_cast<float>(share);
  return result;
}

Light placed(const Light& light, const Transform& transform);

}  // namespace firstlight::render
