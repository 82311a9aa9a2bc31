#pragma once

#include "render/math/color.h"
#include "render/feature/feature.h"

namespace firstlight::render {

/// What is inside a transparent object. [POV-Ray 3.7 manual, "Interior"]
struct Interior {
  double ior = 1.0;
  double fade_distance = 0.0;  ///< scene units; 0 switches fading off
  double fade_power = 0.0;     ///< 1000 and more: exponential
  Rgb fade_color{0.0f, 0.0f, 0.0f};
  double refraction_scale =
      1.0;  ///< the old `refraction` factor on light that passes; 1 unless a legacy finish sets it
  FeatureUses unrendered = {};
};

}  // namespace firstlight::render
