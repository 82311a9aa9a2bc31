#include "render/texture/pigment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace firstlight::render {
namespace {

/// A filter or transmit below this lets no light through. [POV-Ray 3.7]
constexpr double kOpaqueBelow = 1e-10;
/// Patterns are evaluated no farther from their origin than this. [POV-Ray 3.7]
constexpr double kFarthest = 1e17;
/// One period of the phase. A little above 1, so that the value 1 of a pattern is not folded to 0. [POV-Ray 3.7]
constexpr double kPeriod = 1.00001;

double fraction(double value) { return value - std::floor(value); }

/// POV-Ray keeps map positions and the numbers of waves in single precision, and computes with them in double.
double stored(double number) { return static_cast<float>(number); }

/// Place in the colour map, for a pattern's bare value. [POV-Ray 3.7 manual, "Wave Forms"]
double shaped(const Wave& wave, double value) {
  const double frequency = stored(wave.frequency);
  if (frequency != 0.0) value = std::fmod(value * frequency + stored(wave.phase), kPeriod);
  if (value < 0.0) value -= std::floor(value);
  switch (wave.form) {
    case WaveForm::ramp:
      return value;
    case WaveForm::triangle: {
      const double along = fraction(value);
      return along >= 0.5 ? 2.0 * (1.0 - along) : 2.0 * along;
    }
    case WaveForm::sine:
      return 0.5 * (1.0 + std::sin(2.0 * std::numbers::pi * fraction(value)));
    case WaveForm::scallop:
      return std::abs(std::sin(2.0 * std::numbers::pi * fraction(0.5 * value)));
    case WaveForm::cubic:
      return value * value * (3.0 - 2.0 * value);
    case WaveForm::poly:
      return std::pow(value, stored(wave.exponent));
  }
  return value;
}

/// a + t (b - a), every step rounded to single precision as POV-Ray's colours are.
float blend(float a, float b, double t) { return a + static_cast<float>((b - a) * t); }

FilteredColor blend(const FilteredColor& a, const FilteredColor& b, double t) {
  return {{blend(a.rgb.x, b.rgb.x, t), blend(a.rgb.y, b.rgb.y, t), blend(a.rgb.z, b.rgb.z, t)},
          blend(a.filter, b.filter, t),
          blend(a.transmit, b.transmit, t)};
}

/// The colour at `value`: the last entry from its position on, else blended between the first entry that is not below
/// the value and the one before it. Of several entries at one position the first ends the range below, the last
/// begins the range above. Maps are short and need not be sorted, so they are searched from the front.
FilteredColor look_up(const ColorMap& map, double value) {
  if (value >= stored(map.back().position)) return map.back().color;
  std::size_t above = 0;
  while (stored(map[above].position) < value) ++above;
  const double end = stored(map[above].position);
  if (above == 0 || end == value) return map[above].color;
  const double begin = stored(map[above - 1].position);
  return blend(map[above - 1].color, map[above].color, (value - begin) / (end - begin));
}

bool lets_light_through(const FilteredColor& color) {
  return std::abs(color.filter) > kOpaqueBelow || std::abs(color.transmit) > kOpaqueBelow;
}

}  // namespace

FilteredColor color_at(const Pigment& pigment, const Vec3& point) {
  if (!pigment.pattern) return pigment.color;
  if (pigment.map.empty()) return {};
  const Vec3 there = pigment.placement.inverse_point(point);
  const auto inside = [](double x) { return std::clamp(x, -kFarthest, kFarthest); };
  const double value = pigment.pattern->value({inside(there.x), inside(there.y), inside(there.z)});
  if (pigment.stepped) {
    const double last = static_cast<double>(pigment.map.size() - 1);
    return pigment.map[static_cast<std::size_t>(std::clamp(value, 0.0, last))].color;
  }
  return look_up(pigment.map, shaped(pigment.wave, value));
}

bool lets_light_through(const Pigment& pigment) {
  if (!pigment.pattern) return lets_light_through(pigment.color);
  return std::any_of(pigment.map.begin(), pigment.map.end(),
                     [](const ColorMapEntry& entry) { return lets_light_through(entry.color); });
}

}  // namespace firstlight::render
