#pragma once

namespace firstlight::render {

/// Extra samples where the contrast between neighbours asks for them: POV-Ray's options, their names, ranges and
/// defaults.
/// Source   POV-Ray 3.7 manual, "Anti-Aliasing Options".
struct AntialiasSettings {
  int method = 1;          ///< 1: a grid in each pixel that differs from a neighbour; 2: pixels halved again and again
  double threshold = 0.3;  ///< least contrast that asks for samples: 0 to 1, sum over the channels
  int depth = 3;           ///< 1 to 9; method 1: depth x depth samples a pixel; method 2: depth - 1 halvings
  bool jitter = true;      ///< samples are moved a little from their places
  double jitter_amount = 1.0;  ///< 0 to 1
  double gamma = 2.5;          ///< contrast is seen in light ^ (1 / gamma)
  int block_size = 32;         ///< pixels; method 1 decides block by block

  // The meaning of the numbers of the scene's colours: light ^ (1 / working_exponent), or the sRGB curve.
  double working_exponent = 1.0;
  bool working_srgb = false;
};

/// Where in its pixel the first sample lies, in both directions: 0.5 is the middle. Method 2 begins with corners.
inline double base_offset(const AntialiasSettings& settings) { return settings.method == 1 ? 0.5 : 0.0; }

}  // namespace firstlight::render
