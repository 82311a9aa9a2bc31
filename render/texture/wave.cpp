#include "render/texture/wave.h"

#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

/// One period of the phase. A little above 1, so that the value 1 of a pattern is not folded to 0. [POV-Ray 3.7]
constexpr double kPeriod = 1.00001;

double fraction(double value) { return value - std::floor(value); }

/// POV-Ray keeps the numbers of waves in single precision, and computes with them in double.
double stored(double number) { return static_cast<float>(number); }

}  // namespace

double sine_wave(double value) { return std::sin(2.0 * std::numbers::pi * fraction(value)); }

double triangle_wave(double value) {
  const double along = fraction(value);
  return along >= 0.5 ? 2.0 * (1.0 - along) : 2.0 * along;
}

double shaped(const Wave& wave, double value) {
  const double frequency = stored(wave.frequency);
  if (frequency != 0.0) value = std::fmod(value * frequency + stored(wave.phase), kPeriod);
  if (value < 0.0) value -= std::floor(value);
  switch (wave.form) {
    case WaveForm::ramp:
      return value;
    case WaveForm::triangle:
      return triangle_wave(value);
    case WaveForm::sine:
      return 0.5 * (1.0 + sine_wave(value));
    case WaveForm::scallop:
      return std::abs(sine_wave(0.5 * value));
    case WaveForm::cubic:
      return value * value * (3.0 - 2.0 * value);
    case WaveForm::poly:
      return std::pow(value, stored(wave.exponent));
  }
  return value;
}

void shape_all(const Wave& wave, std::size_t count, Column<double>& values) {
  for (std::size_t i = 0; i < count; ++i) values[i] = shaped(wave, values[i]);
}

}  // namespace firstlight::render
