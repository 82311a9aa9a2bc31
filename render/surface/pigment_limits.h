#pragma once

#include "render/texture/pigment.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firstlight::render {

using Channels = std::array<double, 3>;

inline Channels channels_of(const Rgb& color) { return {color.x, color.y, color.z}; }

struct Range {
  double low = INFINITY;
  double high = -INFINITY;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double size() const { return std::max(std::abs(low), std::abs(high)); }
};

/// All that a pigment can be anywhere, channel by channel. Of a map of pigments: what its entries can be, not what lies
/// between them.
struct PigmentLimits {
  /// Colours between two entries of a map are rounded to single precision.
  static constexpr double kBlendError = 1e-6;

  std::array<Range, 3> color;
  std::array<Range, 3> passed;  ///< tint of the light that goes through
  bool is_known = true;         ///< false where colours may be of any size; then the limits are usual ones
  Channels body{};              ///< most of colour times opacity: what its own and its diffuse light are multiplied by

  PigmentLimits(const Pigment& pigment, int language_version, bool quick_colors = false);

  double most_passed() const { return std::max({passed[0].size(), passed[1].size(), passed[2].size()}); }
  double most_color() const { return std::max({color[0].size(), color[1].size(), color[2].size()}); }
  bool has_negative_color() const { return std::min({color[0].low, color[1].low, color[2].low}) < 0.0; }
  /// Whether what it shows of light that is not negative may be.
  bool may_turn_negative() const;
  /// Whether it can only take light away from what goes through.
  bool only_takes() const;

 private:
  void include_all(const Pigment& part);
  void include_image(const ImageUse& use);
  void include(const FilteredColor& from, const FilteredColor& to, double error);

  bool old_opacity_;
  bool quick_colors_;
  double old_opacity_most_ = 0.0;
  double least_opacity_ = 0.0;
};

}  // namespace firstlight::render
