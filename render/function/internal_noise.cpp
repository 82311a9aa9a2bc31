// Noise and the fractals made of it.
// Source   The formulas as POV-Ray 3.7 evaluates them; multifractals by F. K. Musgrave.
#include "render/function/internal.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/function/internal_noise.cpp"
#include <hwy/foreach_target.h>

#include "render/function/internal-inl.h"
#include "render/lanes/math.h"
#include "render/math/noise-inl.h"

#include <algorithm>
#include <array>
#include <cmath>

#ifndef FIRSTLIGHT_INTERNAL_NOISE
#define FIRSTLIGHT_INTERNAL_NOISE(ROW) \
  ROW(29, hetero_mf, 9)                \
  ROW(58, ridge, 9)                    \
  ROW(59, ridged_mf, 9)                \
  ROW(76, noise3d, 3)                  \
  ROW(78, noise_generator, 4)

namespace firstlight::render {
namespace {

/// More octaves than any scene needs; a scene may ask for any number.
constexpr double kMostOctaves = 10000.0;

// The number of a generator, from a parameter.
int generator_of(double number) { return number > -1e9 && number < 1e9 ? static_cast<int>(number) & 3 : 0; }

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

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE L signed_noise(const Vec3Of<L>& point, int generator) {
  return noise(point, generator) * 2.0 - 1.0;
}

template <class L>
HWY_INLINE L noise3d(const Vec3Of<L>& p, const double*, int generator) {
  return noise(p, generator);
}
template <class L>
HWY_INLINE L noise_generator(const Vec3Of<L>& p, const double* own, int) {
  return noise(p, generator_of(own[0]));
}

// Parameters: H, lacunarity, octaves, offset, heterogeneity, generator.
template <class L>
HWY_INLINE L hetero_mf(const Vec3Of<L>& p, const double* own, int) {
  const int generator = generator_of(own[5]);
  const double octaves = std::min(own[2], kMostOctaves);
  const double fading = steady::power(own[1], -own[0]);
  L signal = signed_noise(p, generator) + own[3];
  Vec3Of<L> point = p * L(own[1]);
  double strength = fading;
  for (int i = 1; i < octaves; ++i) {
    L step = (signed_noise(point, generator) + own[3]) * strength;
    for (int power = static_cast<int>(std::clamp(own[4], 0.0, 100.0)); power > 0; --power) step = step * signal;
    signal = signal + step;
    point = point * L(own[1]);
    strength *= fading;
  }
  const double rest = octaves - std::trunc(octaves);
  if (rest != 0.0) signal = signal + rest * ((signed_noise(point, generator) + own[3]) * strength) * signal;
  return signal;
}

// Parameters: lambda, octaves, omega, offset, ridge, generator.
template <class L>
HWY_INLINE L ridge_height(const Vec3Of<L>& point, const double* own, double ridge_scale) {
  return abs(noise(point, generator_of(own[5])) - own[4]) * ridge_scale - own[3];
}
template <class L>
HWY_INLINE L ridge(const Vec3Of<L>& p, const double* own, int) {
  const double octaves = std::min(own[1], kMostOctaves);
  const double ridge_scale = 1.0 / std::max(own[4], 1.0 - own[4]);
  const double scale = 1.0 / std::max(own[3], 1.0 - own[3]);
  L value = ridge_height(p, own, ridge_scale);
  double total = 1.0, size = own[0], strength = own[2];
  for (int i = 2; i <= octaves; ++i) {
    value = value + strength * ridge_height(p * L(size), own, ridge_scale);
    total += strength;
    size *= own[0];
    strength *= own[2];
  }
  const double rest = octaves - std::trunc(octaves);
  if (rest != 0.0) {
    value = value + strength * ridge_height(p * L(size), own, ridge_scale) * rest;
    total += strength * rest;
  }
  return value * scale / total;
}

// Parameters: H, lacunarity, octaves, offset, gain, generator.
template <class L>
HWY_INLINE L crest(const Vec3Of<L>& point, const double* own) {
  const L below = own[3] - abs(signed_noise(point, generator_of(own[5])));
  return below * below;
}
template <class L>
HWY_INLINE L ridged_mf(const Vec3Of<L>& p, const double* own, int) {
  const double octaves = std::min(own[2], kMostOctaves);
  const std::array<double, OctavePowers::kKept>& powers = OctavePowers::of(own[0], own[1]);
  Vec3Of<L> point = p;
  L signal = crest(point, own), result = signal;
  double frequency = 1.0;
  for (int i = 1; i < octaves; ++i) {
    point = point * L(own[1]);
    frequency *= own[1];
    const L weight = clamp(signal * own[4], 0.0, 1.0);
    signal = crest(point, own) * weight;
    const bool is_kept = i < OctavePowers::kKept;
    result = result + signal * (is_kept ? powers[static_cast<std::size_t>(i)] : steady::power(frequency, -own[0]));
  }
  return result;
}

FIRSTLIGHT_INTERNAL_KERNEL(internal_noise, FIRSTLIGHT_INTERNAL_NOISE)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

FIRSTLIGHT_INTERNAL_MEMBERS(internal_noise, FIRSTLIGHT_INTERNAL_NOISE)

}  // namespace firstlight::render
#endif
