#include "render/film/contrast.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

// POV-Ray takes exponents this near to 1 for 1; then colours below black stay as they are.
float unless_nearly_one(float exponent) { return std::abs(1.0 - exponent) <= 0.01 ? 1.0f : exponent; }

}  // namespace

Contrast::Contrast(const AntialiasSettings& settings)
    : working_srgb_(settings.working_srgb),
      exponent_(unless_nearly_one(1.0f / static_cast<float>(settings.gamma))),
      threshold_(static_cast<float>(settings.threshold)) {
  const float working = unless_nearly_one(1.0f / static_cast<float>(settings.working_exponent));
  if (!working_srgb_ && working != 1.0f) exponent_ = unless_nearly_one(exponent_ / working);
}

float Contrast::encode(float working) const {
  float light = working;
  if (working_srgb_) {
    light = working < 0.04045f ? working / 12.92f : std::pow((working + 0.055f) / 1.055f, 2.4f);
  }
  return exponent_ == 1.0f ? light : std::pow(std::max(light, 0.0f), exponent_);
}

bool Contrast::between(const PixelColor& a, const PixelColor& b) const {
  const PixelColor difference = a - b;
  return static_cast<double>(std::abs(difference.light.x)) + static_cast<double>(std::abs(difference.light.y)) +
             static_cast<double>(std::abs(difference.light.z)) + static_cast<double>(std::abs(difference.clear)) >=
         threshold_;
}

}  // namespace firstlight::render
