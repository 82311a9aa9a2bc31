#pragma once

#include "render/feature/feature.h"
#include "render/math/color.h"
#include "render/math/shared.h"
#include "render/texture/media.h"

#include <vector>

namespace firstlight::render {

/// The inside of a transparent object. [POV-Ray 3.7 manual, "Interior"]
struct Interior {
  static constexpr int kMostBands = 1000;

  double ior = 1.0;
  bool has_ior = false;  ///< it has been given; else it is that of the air, and nothing is dispersed
  double fade_distance = 0.0;  ///< scene units; 0 switches fading off
  double fade_power = 0.0;     ///< 1000 and more: exponential
  Rgb fade_color{0.0f, 0.0f, 0.0f};
  double caustics = 0.0;
  double dispersion = 1.0;  ///< index for violet over index for red
  int dispersion_samples = 7;  ///< bands that light is split into, 2 to kMostBands
  bool hollow = false;  ///< fog and other media of the surroundings are in it too
  std::vector<Media> media = {};
  double refraction_scale =
      1.0;                      ///< the old `refraction` factor on light that passes; 1 unless a legacy finish sets it
  FeatureUses unrendered = {};  ///< of caustics
};

/// Index for violet over index for red, as it counts.
inline double dispersion_of(const Interior& interior) { return interior.has_ior ? interior.dispersion : 1.0; }

/// Moves the media on.
void move(Shared<Interior>& interior, const Transform& transform);
/// The same of a copy.
Shared<Interior> moved(Shared<Interior> interior, const Transform& transform);
/// Adds what the interior asks for that cannot be rendered.
void gather(const Interior& interior, FeatureUses& uses);
/// Levels of descriptions in it.
std::uint32_t depth_of(const Interior& interior);

}  // namespace firstlight::render
