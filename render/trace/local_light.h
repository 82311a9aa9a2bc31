#pragma once

#include "render/lanes/math.h"
#include "render/math/color.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firstlight::render {

/// Empirical Fresnel term by which metals lose their tint at grazing angles; `cosine` is of the angle to the normal.
/// Source   POV-Ray 3.7: F = 0.014567225 / (x - 1.12)^2 - 0.011612903, x = angle / 90 degrees, kept within [0, 1].
inline double metallic_fresnel(double cosine) {
  const double x = std::abs(steady::arc_cosine(std::clamp(cosine, -1.0, 1.0))) / (std::numbers::pi / 2.0);
  const double f = 0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903;
  return std::clamp(f, 0.0, 1.0);
}

/// `base` tinted by the surface colour as far as the finish is metallic and the angle steep.
inline Rgb metallic_tint(const Rgb& base, const Rgb& surface, double metallic, double cosine) {
  const float share = static_cast<float>(metallic * (1.0 - metallic_fresnel(cosine)));
  return base * (Rgb(1.0f) + (surface - Rgb(1.0f)) * share);
}

}  // namespace firstlight::render
