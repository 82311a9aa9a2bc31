#pragma once

#include "render/math/vec.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// A ball that moves along a curve and grows and shrinks on the way. [POV-Ray 3.7 manual, "Sphere Sweep"]
struct SphereSweepForm {
  enum class Spline : std::uint8_t { linear, cubic, b_spline };
  struct Ball {
    Vec3 center{0.0, 0.0, 0.0};
    double radius = 0.0;
  };

  Spline spline = Spline::linear;
  std::vector<Ball> balls;
  double tolerance = 1e-6;
};

}  // namespace firstlight::render
