#pragma once

#include <ImathColor.h>

#include <algorithm>
#include <cmath>

namespace firstlight::render {

/// Linear-light colour; may leave [0, 1] in both directions.
using Rgb = Imath::C3f;

/// A pigment's value: a colour and how much light it lets through.
/// `filter` light is tinted by `rgb`, `transmit` light is not. [POV-Ray 3.7 manual, "Color Keywords"]
struct FilteredColor {
  Rgb rgb{0.0f, 0.0f, 0.0f};
  float filter = 0.0f;
  float transmit = 0.0f;

  /// Tint of the light that passes: rgb * filter + transmit.
  Rgb passed() const { return rgb * filter + Rgb(transmit); }
};

inline float max_component(const Rgb& c) { return std::max({c.x, c.y, c.z}); }
inline float max_magnitude(const Rgb& c) { return std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}); }
inline bool is_black(const Rgb& c) { return c.x == 0.0f && c.y == 0.0f && c.z == 0.0f; }
/// Luminance with the weights that POV-Ray uses for its grey scale.
inline float grey(const Rgb& c) { return 0.297f * c.x + 0.589f * c.y + 0.114f * c.z; }

}  // namespace firstlight::render
