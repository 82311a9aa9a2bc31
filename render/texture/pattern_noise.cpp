// Patterns made of smooth noise.

#include "render/math/noise.h"
#include "render/texture/field.h"
#include "render/texture/patterns.h"
#include "render/texture/wave.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

/// Six octaves of ridges, each half as strong as the one before.
double granite(const Vec3& point, int generator) {
  double sum = 0.0;
  double scale = 1.0;
  const Vec3 start = point * 4.0;
  for (int octave = 0; octave < 6; ++octave, scale *= 2.0) {
    const double value = noise(start * scale, generator);
    const double ridge = generator == 1 ? std::abs(0.5 - value) : std::min(std::abs(1.0 - 2.0 * value), 0.5);
    sum += ridge / scale;
  }
  return sum;
}

/// Ten octaves, of which all but the oldest generator stretch the middle half of their range.
double wrinkles(const Vec3& point, int generator) {
  const auto fold = [generator](const Vec3& p) {
    const double value = noise(p, generator);
    return generator > 1 ? std::clamp(value * 2.0 - 0.5, 0.0, 1.0) : value;
  };
  double sum = fold(point);
  double lambda = 2.0;
  double omega = 0.5;
  for (int octave = 1; octave < 10; ++octave, lambda *= 2.0, omega *= 0.5) sum += omega * fold(point * lambda);
  return sum / 2.0;
}

/// Where wrinkles lean: sizes of noise vectors, ten octaves.
Vec3 creases(const Vec3& point) {
  Vec3 sum(0.0);
  double scale = 1.0;
  for (int octave = 0; octave < 10; ++octave, scale *= 2.0) {
    const Vec3 value = dnoise(point * scale);
    sum += Vec3(std::abs(value.x / scale), std::abs(value.y / scale), std::abs(value.z / scale));
  }
  return sum;
}

}  // namespace

/// Noise itself; `spotted` is another word for it.
PatternPtr pattern::make_bozo(const PatternRequest& request) {
  return make_field([generator = request.noise_generator](const Vec3& point) { return noise(point, generator); });
}

/// As bozo, but that it tilts normals by a noise vector.
PatternPtr pattern::make_bumps(const PatternRequest& request) {
  return make_field([generator = request.noise_generator](const Vec3& point) { return noise(point, generator); },
                    [](const Vec3& point, const Tilting& tilting) { return dnoise(point) * tilting.amount; });
}

PatternPtr pattern::make_dents(const PatternRequest& request) {
  const auto depth = [generator = request.noise_generator](const Vec3& point) {
    const double value = noise(point, generator);
    return value * value * value;
  };
  return make_field(depth, [depth](const Vec3& point, const Tilting& tilting) {
    return dnoise(point) * (depth(point) * tilting.amount);
  });
}

PatternPtr pattern::make_granite(const PatternRequest& request) {
  return make_field([generator = request.noise_generator](const Vec3& point) { return granite(point, generator); });
}

PatternPtr pattern::make_wrinkles(const PatternRequest& request) {
  return make_field([generator = request.noise_generator](const Vec3& point) { return wrinkles(point, generator); },
                    [](const Vec3& point, const Tilting& tilting) { return creases(point) * tilting.amount; });
}

/// Bands along z that turbulence of the pattern's own strength disturbs; the word `turbulence` says how fine it is.
PatternPtr pattern::make_agate(const PatternRequest& request) {
  const double strength = static_cast<float>(request.get<AgateParameters>().turbulence);
  const Octaves octaves = request.turbulence ? octaves_of(*request.turbulence) : Octaves();
  return make_field([strength, octaves, generator = request.noise_generator](const Vec3& point) {
    const double disturbed = strength * turbulence(point, octaves, generator);
    const double band = 0.5 * (sine_wave(1.3 * disturbed + 1.1 * point.z) + 1.0);
    return band < 0.0 ? 0.0 : std::pow(std::min(1.0, band), 0.77);
  });
}

}  // namespace firstlight::render
