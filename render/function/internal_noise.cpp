// Noise and the fractals made of it.
// Source   The formulas as POV-Ray 3.7 evaluates them; multifractals by F. K. Musgrave.
#include "render/function/internal.h"
#include "render/lanes/math.h"
#include "render/math/noise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firstlight::render {
namespace {

/// More octaves than any scene needs; a scene may ask for any number.
constexpr double kMostOctaves = 10000.0;

Vec3 point_of(const double* p) { return {p[0], p[1], p[2]}; }
// The number of a generator, from a parameter.
int generator_of(double number) { return number > -1e9 && number < 1e9 ? static_cast<int>(number) & 3 : 0; }
double signed_noise(const Vec3& point, int generator) { return noise(point, generator) * 2.0 - 1.0; }

double noise3d(const double* p, const Evaluation& evaluation) { return noise(point_of(p), evaluation.noise_generator); }

double noise_generator(const double* p, const Evaluation&) { return noise(point_of(p), generator_of(p[3])); }

// Parameters: H, lacunarity, octaves, offset, heterogeneity, generator.
double hetero_mf(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const int generator = generator_of(own[5]);
  const double octaves = std::min(own[2], kMostOctaves);
  const double fading = steady::power(own[1], -own[0]);
  Vec3 point = point_of(p);
  double signal = signed_noise(point, generator) + own[3];
  point *= own[1];
  double strength = fading;
  for (int i = 1; i < octaves; ++i) {
    double step = (signed_noise(point, generator) + own[3]) * strength;
    for (int power = static_cast<int>(std::clamp(own[4], 0.0, 100.0)); power > 0; --power) step *= signal;
    signal += step;
    point *= own[1];
    strength *= fading;
  }
  const double rest = octaves - std::trunc(octaves);
  if (rest != 0.0) signal += rest * ((signed_noise(point, generator) + own[3]) * strength) * signal;
  return signal;
}

// Parameters: lambda, octaves, omega, offset, ridge, generator.
double ridge(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const int generator = generator_of(own[5]);
  const double octaves = std::min(own[1], kMostOctaves), offset = own[3];
  const double ridge_scale = 1.0 / std::max(own[4], 1.0 - own[4]);
  const double scale = 1.0 / std::max(offset, 1.0 - offset);
  const auto height = [&](const Vec3& point) {
    return std::abs(noise(point, generator) - own[4]) * ridge_scale - offset;
  };
  double value = height(point_of(p));
  double total = 1.0, size = own[0], strength = own[2];
  for (int i = 2; i <= octaves; ++i) {
    value += strength * height(point_of(p) * size);
    total += strength;
    size *= own[0];
    strength *= own[2];
  }
  const double rest = octaves - std::trunc(octaves);
  if (rest != 0.0) {
    value += strength * height(point_of(p) * size) * rest;
    total += strength * rest;
  }
  return value * scale / total;
}

/// frequency^-H of the octaves of a fractal, which many points ask for one after the other.
class OctavePowers {
 public:
  static constexpr int kKept = 24;

  /// The powers of octaves from 1 up to kKept - 1.
  static const std::array<double, kKept>& of(double h, double lacunarity) {
    thread_local OctavePowers kept;
    if (kept.h_ != h || kept.lacunarity_ != lacunarity) kept = OctavePowers(h, lacunarity);
    return kept.powers_;
  }

 private:
  OctavePowers() : OctavePowers(1.0, 2.0) {}
  OctavePowers(double h, double lacunarity) : h_(h), lacunarity_(lacunarity) {
    double frequency = 1.0;
    for (double& power : powers_) {
      power = steady::power(frequency, -h);
      frequency *= lacunarity;
    }
  }

  double h_;
  double lacunarity_;
  std::array<double, kKept> powers_;
};

double ridged_mf(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const int generator = generator_of(own[5]);
  const double octaves = std::min(own[2], kMostOctaves);
  const auto crest = [&](const Vec3& point) {
    const double below = own[3] - std::abs(signed_noise(point, generator));
    return below * below;
  };
  const std::array<double, OctavePowers::kKept>& powers = OctavePowers::of(own[0], own[1]);
  Vec3 point = point_of(p);
  double signal = crest(point), result = signal, frequency = 1.0;
  for (int i = 1; i < octaves; ++i) {
    point *= own[1];
    frequency *= own[1];
    const double weight = std::clamp(signal * own[4], 0.0, 1.0);
    signal = crest(point) * weight;
    const bool is_kept = i < OctavePowers::kKept;
    result += signal * (is_kept ? powers[static_cast<std::size_t>(i)] : steady::power(frequency, -own[0]));
  }
  return result;
}

constexpr InternalFunction kRows[] = {
    {29, hetero_mf, 9}, {58, ridge, 9}, {59, ridged_mf, 9}, {76, noise3d, 3}, {78, noise_generator, 4},
};

}  // namespace

std::span<const InternalFunction> internal_noise() { return kRows; }

}  // namespace firstlight::render
