#include "render/image/transfer_curve.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

/// Powers are told apart from each other, and from none, by a hundredth. [POV-Ray 3.7]
bool is_one(float ratio) { return std::abs(1.0 - static_cast<double>(ratio)) <= 0.01; }

TransferCurve power_of(float encoding) {
  if (is_one(encoding)) return {};
  return {TransferCurve::Kind::power, encoding};
}

bool are_equal(const TransferCurve& a, const TransferCurve& b) {
  if (a.kind != b.kind) return false;
  return a.kind != TransferCurve::Kind::power || is_one(a.encoding / b.encoding);
}

}  // namespace

TransferCurve TransferCurve::of_power(double exponent) { return power_of(1.0f / static_cast<float>(exponent)); }

// sRGB is IEC 61966-2-1.
float TransferCurve::to_light(float number) const {
  switch (kind) {
    case Kind::linear:
      return number;
    case Kind::srgb:
      return number < 0.04045f ? number / 12.92f : std::pow((number + 0.055f) / 1.055f, 2.4f);
    case Kind::power:
      return std::pow(std::max(number, 0.0f), 1.0f / encoding);
  }
  return number;
}

float TransferCurve::from_light(float light) const {
  switch (kind) {
    case Kind::linear:
      return light;
    case Kind::srgb:
      return light <= 0.0031308f ? light * 12.92f : 1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f;
    case Kind::power:
      return std::pow(std::max(light, 0.0f), encoding);
  }
  return light;
}

Transcoding::Transcoding(const TransferCurve& from, const TransferCurve& to) : from_(from), to_(to) {
  using Kind = TransferCurve::Kind;
  if (are_equal(from, to)) {
    from_ = to_ = {};
  } else if (to.kind == Kind::power && from.kind != Kind::srgb) {
    // Two powers are one.
    from_ = power_of((1.0f / to.encoding) * (from.kind == Kind::power ? from.encoding : 1.0f));
    to_ = {};
  }
}

float Transcoding::operator()(float number) const { return to_.from_light(from_.to_light(number)); }

}  // namespace firstlight::render
