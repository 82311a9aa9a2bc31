#pragma once

#include "render/math/pixel_color.h"

#include <vector>

namespace firstlight::render {

/// How many samples a place of a picture with focal blur gets.
struct BlurSettings {
  int samples = 0;      ///< at most
  int min_samples = 0;  ///< at least
  double confidence = 0.9;
  double variance = 1e-4;
  bool is_round = true;  ///< the lens; those of a shape of their own take samples in other portions
};

/// Sums over the samples of a place, added in their order.
struct PlaceSums {
  int count = 0;
  PixelColor sum;
  PixelColor squares;

  void add(const PixelColor& color) {
    ++count;
    sum += color;
    squares += PixelColor(color.light * color.light, color.clear * color.clear);
  }
  PixelColor mean() const { return mean_of(sum, count); }
};

/// When a place has samples enough: where the mean is likely to be near.
///
/// Source   POV-Ray 3.7: single precision as there. The test is the chi-square's; colours are unclipped.
/// Threads  Immutable.
class BlurRule {
 public:
  explicit BlurRule(const BlurSettings& settings);

  int most() const { return settings_.samples; }
  /// The first number of samples above `count` at which is_enough() is to be asked. Pre: count < most().
  int next_stop(int count) const;
  /// Pre: sums.count is such a number.
  bool is_enough(const PlaceSums& sums) const;

 private:
  BlurSettings settings_;
  std::vector<double> thresholds_;  ///< by number of samples, at the stops
};

}  // namespace firstlight::render
