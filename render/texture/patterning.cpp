#include "render/texture/patterning.h"

#include "render/texture/patterns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

/// Patterns are evaluated no farther from their origin than this. [POV-Ray 3.7]
constexpr double kFarthest = 1e17;
/// One period of the phase. A little above 1, so that the value 1 of a pattern is not folded to 0. [POV-Ray 3.7]
constexpr double kPeriod = 1.00001;

double fraction(double value) { return value - std::floor(value); }

/// POV-Ray keeps the numbers of waves in single precision, and computes with them in double.
double stored(double number) { return static_cast<float>(number); }

}  // namespace

std::shared_ptr<const Pattern> make_pattern(PatternKind kind, const PatternParameters& parameters) {
  switch (kind) {
    case PatternKind::boxed:
      return make_boxed();
    case PatternKind::brick:
      return make_brick(std::get<BrickParameters>(parameters));
    case PatternKind::checker:
      return make_checker();
    case PatternKind::cubic:
      return make_cubic();
    case PatternKind::cylindrical:
      return make_cylindrical();
    case PatternKind::gradient:
      return make_gradient(std::get<GradientParameters>(parameters).axis);
    case PatternKind::hexagon:
      return make_hexagon();
    case PatternKind::julia:
    case PatternKind::magnet:
    case PatternKind::mandel:
      return make_fractal(std::get<FractalParameters>(parameters));
    case PatternKind::leopard:
      return make_leopard();
    case PatternKind::marble:
      return make_marble();
    case PatternKind::onion:
      return make_onion();
    case PatternKind::planar:
      return make_planar();
    case PatternKind::quilted:
      return make_quilted(std::get<QuiltedParameters>(parameters));
    case PatternKind::radial:
      return make_radial();
    case PatternKind::spherical:
      return make_spherical();
    case PatternKind::spiral1:
      return make_spiral1(std::get<SpiralParameters>(parameters));
    case PatternKind::spiral2:
      return make_spiral2(std::get<SpiralParameters>(parameters));
    case PatternKind::square:
      return make_square();
    case PatternKind::triangular:
      return make_triangular();
    case PatternKind::wood:
      return make_wood();
    default:
      return nullptr;
  }
}

Patterning patterned(PatternKind kind, PatternParameters parameters) {
  Patterning result;
  result.kind = kind;
  result.parameters = std::move(parameters);
  result.field = make_pattern(kind, result.parameters);
  if (is_list(kind)) result.wave.frequency = 0.0;
  return result;
}

double value_at(const Patterning& patterning, const Vec3& point) {
  const Vec3 there = patterning.warps.to_pattern(point);
  const auto inside = [](double x) { return std::clamp(x, -kFarthest, kFarthest); };
  return patterning.field->value({inside(there.x), inside(there.y), inside(there.z)});
}

void gather(const Patterning& patterning, FeatureUses& uses) {
  if (!is_patterned(patterning.kind)) return;
  uses.add(patterning.unrendered);
  uses.add(patterning.warps.unrendered);
}

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

}  // namespace firstlight::render
