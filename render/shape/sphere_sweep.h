#pragma once

#include "render/shape/shape.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// A ball that moves along a curve and grows and shrinks on the way. [POV-Ray 3.7 manual, "Sphere Sweep"]
struct SphereSweepParameters {
  /// cubic: Catmull and Rom's, through all balls but the first and the last.
  enum class Spline : std::uint8_t { linear, cubic, b_spline };
  struct Ball {
    Vec3 center{0.0, 0.0, 0.0};
    double radius = 0.0;
  };

  Spline spline = Spline::linear;
  std::vector<Ball> balls;   ///< at least 2 of a linear one, else 4
  double tolerance = 1e-6;  ///< nearer crossings are taken for the surface that a ray starts on
};

ShapePtr make_sphere_sweep(const SphereSweepParameters& parameters);

}  // namespace firstlight::render
