#pragma once

#include "render/film/antialias_settings.h"
#include "render/math/pixel_color.h"

namespace firstlight::render {

/// How different two colours look to anti-aliasing.
/// Source   POV-Ray 3.7's Antialias_Gamma; unclipped, in single precision as there.
class Contrast {
 public:
  explicit Contrast(const AntialiasSettings& settings);

  /// A colour as it is compared.
  PixelColor encode(const PixelColor& color) const {
    if (!working_srgb_ && exponent_ == 1.0f) return color;
    return {Rgb(encode(color.light.x), encode(color.light.y), encode(color.light.z)), color.clear};
  }
  /// Whether two encoded colours ask for more samples.
  bool between(const PixelColor& a, const PixelColor& b) const;

 private:
  float encode(float working) const;

  bool working_srgb_;
  float exponent_;
  double threshold_;
};

}  // namespace firstlight::render
