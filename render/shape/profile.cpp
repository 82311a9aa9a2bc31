#include "render/shape/profile.h"

#include "render/lanes/math.h"
#include "render/math/polynomial.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

void include(ProfileSegment& segment, const Vec2& point) {
  for (int axis = 0; axis < 2; ++axis) {
    segment.low[axis] = std::min(segment.low[axis], point[axis]);
    segment.high[axis] = std::max(segment.high[axis], point[axis]);
  }
}

/// Where the curve turns around along an axis.
void include_turns(ProfileSegment& segment) {
  for (int axis = 0; axis < 2; ++axis) {
    // 3 a w^2 + 2 b w + c = 0
    const double a = 3.0 * segment.a[axis];
    const double b = segment.b[axis];
    const double c = segment.c[axis];
    std::array<double, 2> turns{-1.0, -1.0};
    if (std::abs(a) < kEpsilon) {
      if (b != 0.0) turns[0] = -0.5 * c / b;
    } else if (b * b - a * c >= 0.0) {
      const double root = std::sqrt(b * b - a * c);
      turns = {(-b + root) / a, (-b - root) / a};
    }
    for (const double w : turns) {
      if (!(w >= 0.0 && w <= 1.0)) continue;
      const double place = segment.at(w)[axis];
      segment.low[axis] = std::min(segment.low[axis], place);
      segment.high[axis] = std::max(segment.high[axis], place);
    }
  }
}

}  // namespace

ProfileSegment profile_segment(ProfileSpline spline, const std::vector<Vec2>& points, std::size_t first) {
  const Vec2* p = points.data() + first;
  ProfileSegment segment{Vec2(0.0), Vec2(0.0), Vec2(0.0), Vec2(0.0), p[1], p[1]};
  switch (spline) {
    case ProfileSpline::linear:
      segment.c = p[1] - p[0];
      segment.d = p[0];
      break;
    case ProfileSpline::quadratic:
      segment.b = p[0] * 0.5 - p[1] + p[2] * 0.5;
      segment.c = (p[2] - p[0]) * 0.5;
      segment.d = p[1];
      break;
    case ProfileSpline::cubic:
      segment.a = p[1] * 1.5 - p[0] * 0.5 - p[2] * 1.5 + p[3] * 0.5;
      segment.b = p[0] - p[1] * 2.5 + p[2] * 2.0 - p[3] * 0.5;
      segment.c = (p[2] - p[0]) * 0.5;
      segment.d = p[1];
      break;
    case ProfileSpline::bezier:
      segment.a = p[3] - p[2] * 3.0 + p[1] * 3.0 - p[0];
      segment.b = p[2] * 3.0 - p[1] * 6.0 + p[0] * 3.0;
      segment.c = (p[1] - p[0]) * 3.0;
      segment.d = p[0];
      break;
  }
  if (spline == ProfileSpline::bezier) {
    for (std::size_t i = 0; i < 4; ++i) include(segment, p[i]);
    return segment;
  }
  const bool through_first = spline == ProfileSpline::linear;
  include(segment, through_first ? p[0] : p[1]);
  include(segment, through_first ? p[1] : p[2]);
  if (!through_first) include_turns(segment);
  return segment;
}

std::size_t crossings_beside(const ProfileSegment& segment, double u, double v) {
  if (v < segment.low.y || v > segment.high.y || u > segment.high.x) return 0;
  const std::array<double, 4> height = {segment.d.y - v, segment.c.y, segment.b.y, segment.a.y};
  PolynomialRoots roots(height, 0.0, 1.0);
  std::size_t count = 0;
  for (double w; roots.next(w);) count += segment.at(w).x >= u ? 1 : 0;
  return count;
}

double turn_about_y(double x, double z) {
  const double squared = x * x + z * z;
  if (!(squared > kEpsilon)) return 0.0;
  const double angle = steady::arc_cosine(std::clamp(x / std::sqrt(squared), -1.0, 1.0));
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return (z < 0.0 ? kTurn - angle : angle) / kTurn;
}

}  // namespace firstlight::render
