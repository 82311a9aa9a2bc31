#include "render/image/encode.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace firstlight::render {
namespace {

// The sRGB curve in single precision, as POV-Ray computes it.
float to_srgb(float light) {
  return light <= 0.0031308f ? light * 12.92f : 1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f;
}

float from_srgb(float value) { return value < 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f); }

}  // namespace

Encoding Encoding::power(double exponent) {
  // POV-Ray's tolerance is on the reciprocal.
  return std::abs(1.0 - 1.0 / exponent) <= 0.01 ? linear() : Encoding(Curve::srgb, exponent);
}

std::uint8_t Encoding::byte(float working) const {
  float value = working;
  if (curve_ == Curve::srgb) {
    if (exponent_ != 1.0f) value = std::pow(std::max(value, 0.0f), exponent_);
    value = to_srgb(value);
  }
  if (!(value > 0.0f)) return 0;
  return static_cast<std::uint8_t>(std::floor(std::min(value, 1.0f) * 255.0f + 0.5f));
}

float Encoding::light(float working) const {
  float value = working;
  if (curve_ == Curve::none) value = from_srgb(working);
  if (exponent_ != 1.0f) value = std::pow(std::max(working, 0.0f), exponent_);
  if (std::isnan(value)) return 0.0f;
  constexpr float kLargest = std::numeric_limits<float>::max();
  return std::clamp(value, -kLargest, kLargest);
}

std::vector<std::uint8_t> to_bytes(std::span<const Rgb> colors, const Encoding& encoding) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(colors.size() * 3);
  for (const Rgb& color : colors) {
    for (const float channel : {color.x, color.y, color.z}) bytes.push_back(encoding.byte(channel));
  }
  return bytes;
}

std::vector<float> to_light(std::span<const Rgb> colors, const Encoding& encoding) {
  std::vector<float> values;
  values.reserve(colors.size() * 3);
  for (const Rgb& color : colors) {
    for (const float channel : {color.x, color.y, color.z}) values.push_back(encoding.light(channel));
  }
  return values;
}

}  // namespace firstlight::render
