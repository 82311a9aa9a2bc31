#include "render/light/spectrum.h"

#include "render/lanes/math.h"
#include "render/math/vec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace firstlight::render {
namespace {

// Wavelengths in nm.
constexpr double kViolet = 380.0;
constexpr double kRed = 730.0;
constexpr double kWidth = kRed - kViolet;
constexpr double kMiddle = (kViolet + kRed) / 2.0;

float wavelength(SpectralBand band) {
  return static_cast<float>(kViolet +
                            kWidth * ((static_cast<float>(band.number) + 0.5) / static_cast<float>(band.count)));
}

/// A parabola about `middle`, of height `top`, where it is above 0.
double hill(double place, double top, double steepness, double middle) {
  const double side = steepness * (place - middle);
  return std::max(0.0, top - side * side);
}

/// How much of red, green and blue lies below a wavelength, all of it being 1: piecewise linear between steps of 5 nm,
/// of which each holds what fits to the eye's colour matching. To four decimals, as POV-Ray has it.
class Sums {
 public:
  Sums() {
    Vec3 sum(0.0);
    for (std::size_t i = 1; i < kSteps; ++i) {
      const double place = 0.03 + 0.934 * static_cast<double>(i) / static_cast<double>(kSteps - 1);
      const double main_red = hill(place, 1.15, 5.0, 0.75);
      const double red = main_red > 0.0 ? main_red : hill(place, 0.12, 4.0, 0.12);
      sum += Vec3(red, hill(place, 1.1, 4.5, 0.57), hill(place, 1.0, 4.0, 0.28));
      below_[i] = sum;
    }
    constexpr double kDecimals = 1e4;
    for (Vec3& below : below_) {
      for (int channel = 0; channel < 3; ++channel) {
        below[channel] = std::round(below[channel] / sum[channel] * kDecimals) / kDecimals;
      }
    }
  }

  Vec3 below(double wavelength) const {
    const double place = std::clamp((wavelength - kFirst) / kStep, 0.0, kSteps - 1.0);
    const std::size_t step = std::min(static_cast<std::size_t>(place), kSteps - 2);
    const double beyond = place - static_cast<double>(step);
    return below_[step] * (1.0 - beyond) + below_[step + 1] * beyond;
  }

 private:
  static constexpr std::size_t kSteps = 74;
  static constexpr double kFirst = 375.0;
  static constexpr double kStep = 5.0;

  std::array<Vec3, kSteps> below_{Vec3(0.0)};
};

}  // namespace

Rgb hue(SpectralBand band) {
  static const Sums sums;
  const double middle = wavelength(band);
  const double width = static_cast<float>(kWidth / static_cast<double>(band.count));
  return Rgb((sums.below(middle + width / 2.0) - sums.below(middle - width / 2.0)) * (kWidth / width));
}

double dispersed_ior(double ior, double dispersion, SpectralBand band) {
  return ior * steady::power(dispersion, -(static_cast<double>(wavelength(band)) - kMiddle) / kWidth);
}

}  // namespace firstlight::render
