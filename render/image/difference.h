#pragma once

#include "render/math/color.h"

#include <span>

namespace firstlight::render {

/// Mean over pixels and channels of |a - b|, of colours as a display can show them: clipped to [0, 1], not-a-number
/// black.
/// Units    Linear light, white is 1.
/// Pre      Equal sizes.
double mean_absolute_difference(std::span<const Rgb> a, std::span<const Rgb> b);

/// How far a picture in progress is from the finished one, by the mean absolute difference: 1 for a black picture, 0
/// when nothing is left. A finished picture that is black itself counts as 1 away from all others.
/// Source   Yagel & Meeker 1997, figure 7; the black picture as the unit is ours, so that scenes can be compared.
class RemainingDifference {
 public:
  /// Pre: `finished` outlives this.
  explicit RemainingDifference(std::span<const Rgb> finished);
  double operator()(std::span<const Rgb> picture) const;
  /// Mean absolute difference of the black picture.
  double of_black() const { return black_; }

 private:
  std::span<const Rgb> finished_;
  double black_;
};

}  // namespace firstlight::render
