#pragma once

#include "render/math/vec.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// How a curve goes through its points, or near them.
enum class ProfileSpline : std::uint8_t { linear, quadratic, cubic, bezier };

/// A curve in the plane that turns around the y axis. x is the distance from the axis. [POV-Ray 3.7 manual, "Lathe"]
struct LatheForm {
  ProfileSpline spline = ProfileSpline::linear;
  std::vector<Vec2> points;
};

/// The same with a curve that rises all the way; the first and last points only give it its direction.
/// [POV-Ray 3.7 manual, "Surface of Revolution"]
struct SurfaceOfRevolutionForm {
  std::vector<Vec2> points;
  bool open = false;  ///< without the two caps
};

/// Closed curves in the xz plane, swept along the y axis. [POV-Ray 3.7 manual, "Prism"]
struct PrismForm {
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

/// A flat surface between closed lines, one after the other, each ending with the point that it began with.
struct PolygonForm {
  std::vector<Vec3> points;
};

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
