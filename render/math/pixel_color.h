#pragma once

#include "render/math/color.h"

#include <cmath>

namespace firstlight::render {

/// A place of the picture: its light, and the share of what is behind the scene that shows through. The share is 0 in
/// pictures without an alpha channel, and alpha is what is left of 1. Light is never multiplied by it: where all
/// shows through there is none.
struct PixelColor {
  Rgb light{0.0f, 0.0f, 0.0f};
  float clear = 0.0f;

  PixelColor() = default;
  PixelColor(const Rgb& color, float share = 0.0f) : light(color), clear(share) {}

  PixelColor& operator+=(const PixelColor& other) { return *this = *this + other; }
  PixelColor operator+(const PixelColor& other) const { return {light + other.light, clear + other.clear}; }
  PixelColor operator-(const PixelColor& other) const { return {light - other.light, clear - other.clear}; }
  PixelColor operator*(float factor) const { return {light * factor, clear * factor}; }
  PixelColor operator/(float divisor) const { return {light / divisor, clear / divisor}; }
  bool operator==(const PixelColor&) const = default;
};

/// The mean of as many places as `sum` is of: in double precision, as POV-Ray does.
inline PixelColor mean_of(const PixelColor& sum, double count) {
  const auto share = [count](float channel) { return static_cast<float>(static_cast<double>(channel) / count); };
  return {Rgb(share(sum.light.x), share(sum.light.y), share(sum.light.z)), share(sum.clear)};
}

}  // namespace firstlight::render
