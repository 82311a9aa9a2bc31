#pragma once

#include "render/math/color.h"
#include "render/math/transform.h"
#include "render/math/vec.h"

namespace firstlight::render {

/// A point light. Plain data.
/// Source   POV-Ray 3.7 manual, "Light Source".
struct Light {
  Vec3 position{0.0, 0.0, 0.0};
  Rgb color{1.0f, 1.0f, 1.0f};
  bool shadowless = false;    ///< lights without being blocked, and gives no highlights
  double fade_distance = 0.0;  ///< scene units
  double fade_power = 0.0;     ///< 0: no fading
};

/// Light that arrives at a point, were nothing in the way.
struct Illumination {
  Vec3 direction;  ///< unit, from the point to the light
  double distance = 0.0;
  Rgb color;
};

Illumination illuminate(const Light& light, const Vec3& point);
Light placed(const Light& light, const Transform& transform);

}  // namespace firstlight::render
