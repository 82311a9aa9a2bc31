#pragma once

#include "render/shape/profile.h"
#include "render/shape/shape.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// Closed curves in the xz plane, swept along the y axis. [POV-Ray 3.7 manual, "Prism"]
struct PrismParameters {
  /// conic: at height y the curves are y times as large.
  enum class Sweep : std::uint8_t { linear, conic };

  ProfileSpline spline = ProfileSpline::linear;
  Sweep sweep = Sweep::linear;
  double low = 0.0;  ///< not above `high`
  double high = 0.0;
  /// One curve after the other, each closed: it ends with the point that it began with. Of quadratic and cubic curves
  /// the points that only give the direction stand before, and of cubic ones behind them too.
  std::vector<Vec2> points;
  bool open = false;
};

ShapePtr make_prism(const PrismParameters& parameters);
/// A letter of a text: closed curves in the xy plane, swept from z = 0 to z = `thickness`.
ShapePtr make_letter(std::vector<ProfileSegment> outline, double thickness);

}  // namespace firstlight::render
