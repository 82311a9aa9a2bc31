#pragma once

#include "render/shape/profile.h"
#include "render/shape/shape.h"

#include <vector>

namespace firstlight::render {

/// A curve in the plane that turns around the y axis. x is the distance from the axis. [POV-Ray 3.7 manual, "Lathe"]
struct LatheParameters {
  ProfileSpline spline = ProfileSpline::linear;
  std::vector<Vec2> points;  ///< at least 2, 3, 4, and a multiple of 4 for Bezier curves
};

ShapePtr make_lathe(const LatheParameters& parameters);

}  // namespace firstlight::render
