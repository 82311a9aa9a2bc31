#pragma once

#include "render/film/antialias_settings.h"
#include "render/math/color.h"

namespace firstlight::render {

/// How different two colours look to anti-aliasing.
/// Source   POV-Ray 3.7's Antialias_Gamma; unclipped, in single precision as there.
class Contrast {
 public:
  explicit Contrast(const AntialiasSettings& settings);

  /// A colour as it is compared.
  Rgb encode(const Rgb& color) const {
    if (!working_srgb_ && exponent_ == 1.0f) return color;
    return {encode(color.x), encode(color.y), encode(color.z)};
  }
  /// Whether two encoded colours ask for more samples.
  bool between(const Rgb& a, const Rgb& b) const;

 private:
  float encode(float working) const;

  bool working_srgb_;
  float exponent_;
  double threshold_;
};

}  // namespace firstlight::render
