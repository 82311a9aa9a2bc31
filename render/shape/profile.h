#pragma once

#include "render/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace firstlight::render {

/// How a curve goes through its points, or near them.
enum class ProfileSpline : std::uint8_t { linear, quadratic, cubic, bezier };

/// A part of a curve in the plane: ((a w + b) w + c) w + d for w from 0 to 1.
struct ProfileSegment {
  Vec2 a, b, c, d;
  Vec2 low, high;  ///< a rectangle about it

  Vec2 at(double w) const { return ((a * w + b) * w + c) * w + d; }
  Vec2 slope(double w) const { return (a * (3.0 * w) + b * 2.0) * w + c; }
};

/// The part of a curve that begins at points[first], or between it and the next where a point gives the direction.
/// Source   POV-Ray 3.7: quadratic and cubic ones are Catmull-Rom splines; the rectangle of a Bezier part is that of its
///          four points.
/// Pre: there are as many points behind it as the spline asks for: 1, 2, 3, 3.
ProfileSegment profile_segment(ProfileSpline spline, const std::vector<Vec2>& points, std::size_t first);

/// How often a line from (u, v) in the direction of growing u meets the segment.
std::size_t crossings_beside(const ProfileSegment& segment, double u, double v);

/// Angle of (x, z) around the y axis, from 0 to 1. [POV-Ray 3.7]
double turn_about_y(double x, double z);

}  // namespace firstlight::render
