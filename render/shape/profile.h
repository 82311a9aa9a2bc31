#pragma once

#include "render/math/columns.h"
#include "render/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
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
  /// 1, 2 or 3: the highest power of w.
  std::size_t order() const { return a != Vec2(0.0) ? 3 : b != Vec2(0.0) ? 2 : 1; }
};

/// The part of a curve that begins at points[first], or between it and the next where a point gives the direction.
/// Source   POV-Ray 3.7: quadratic and cubic ones are Catmull-Rom splines; the rectangle of a Bezier part is that of its
///          four points.
/// Pre: there are as many points behind it as the spline asks for: 1, 2, 3, 3.
ProfileSegment profile_segment(ProfileSpline spline, const std::vector<Vec2>& points, std::size_t first);

/// The highest of their orders: of all their equations, which are solved side by side.
std::size_t highest_order(std::span<const ProfileSegment> segments);

/// Whether a line from (u, v) in the direction of growing u meets the curves an odd number of times.
bool is_in_curves(std::span<const ProfileSegment> segments, double u, double v);
/// The bits of those points of which it does, among those in `who`.
std::uint64_t points_in_curves(std::span<const ProfileSegment> segments, const Column<double>& u,
                               const Column<double>& v, std::uint64_t who);

/// Angle of (x, z) around the y axis, from 0 to 1. [POV-Ray 3.7]
double turn_about_y(double x, double z);

}  // namespace firstlight::render
