#include "render/shape/profile.h"

#include "render/lanes/math.h"
#include "render/math/polynomial.h"
#include "render/shape/root_jobs.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/profile.cpp"
#include <hwy/foreach_target.h>

#include "render/math/polynomial-inl.h"
#include "render/shape/profile-inl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// The lanes of points for which a line in the direction of growing u may meet the segment.
HWY_INLINE LanesMask is_beside(const ProfileSegment& segment, const Lanes& u, const Lanes& v) {
  return !((v < segment.low.y) | (v > segment.high.y) | (u > segment.high.x));
}

/// The bits of such points.
std::uint64_t points_beside(const ProfileSegment& segment, const Column<double>& u, const Column<double>& v,
                            std::uint64_t who) {
  std::uint64_t beside = 0;
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    if ((who >> i & kAllLanes) == 0) continue;
    beside |= std::uint64_t{bits(is_beside(segment, load<Lanes>(u, i), load<Lanes>(v, i)))} << i;
  }
  return beside & who;
}

/// As points_in_curves(), for lines and parabolas.
std::uint64_t points_in_few(std::span<const ProfileSegment> segments, const Column<double>& us,
                            const Column<double>& vs, std::uint64_t who) {
  std::uint64_t holding = 0;
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    const std::uint64_t of_vector = who >> i & kAllLanes;
    if (of_vector == 0) continue;
    const auto u = load<Lanes>(us, i);
    const auto v = load<Lanes>(vs, i);
    unsigned odd = 0;
    for (const ProfileSegment& segment : segments) {
      const LanesMask beside = is_beside(segment, u, v);
      if (!any(beside)) continue;
      const Lanes c[3] = {segment.d.y - v, segment.c.y, segment.b.y};
      const FewRoots<Lanes> roots = few_roots(c, Lanes(0.0), Lanes(1.0));
      const auto is_ahead = [&](const Lanes& w) HWY_ATTR { return place_on(segment, w).x >= u; };
      odd ^= bits(beside & roots.has_first & is_ahead(roots.first)) ^
             bits(beside & roots.has_second & is_ahead(roots.second));
    }
    holding |= (odd & of_vector) << i;
  }
  return holding;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(points_beside);
HWY_EXPORT(points_in_few);

namespace {

std::array<double, 4> height_above(const ProfileSegment& segment, double v) {
  return {segment.d.y - v, segment.c.y, segment.b.y, segment.a.y};
}

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

std::size_t highest_order(std::span<const ProfileSegment> segments) {
  std::size_t order = 1;
  for (const ProfileSegment& segment : segments) order = std::max(order, segment.order());
  return order;
}

bool is_in_curves(std::span<const ProfileSegment> segments, double u, double v) {
  bool is_in = false;
  const std::size_t order = highest_order(segments);
  for (const ProfileSegment& segment : segments) {
    if (v < segment.low.y || v > segment.high.y || u > segment.high.x) continue;
    const std::array<double, 4> height = height_above(segment, v);
    PolynomialRoots roots({height.data(), order + 1}, 0.0, 1.0);
    for (double w; roots.next(w);) is_in ^= segment.at(w).x >= u;
  }
  return is_in;
}

std::uint64_t points_in_curves(std::span<const ProfileSegment> segments, const Column<double>& u,
                               const Column<double>& v, std::uint64_t who) {
  const std::size_t order = highest_order(segments);
  if (order <= 2) return HWY_DYNAMIC_DISPATCH(points_in_few)(segments, u, v, who);
  std::uint64_t holding = 0;
  RootJobs jobs([&](std::size_t point, std::uint32_t part, double w) {
    if (segments[part].at(w).x >= u[point]) holding ^= std::uint64_t{1} << point;
  });
  for (std::uint32_t part = 0; part < segments.size(); ++part) {
    const ProfileSegment& segment = segments[part];
    for (std::uint64_t left = HWY_DYNAMIC_DISPATCH(points_beside)(segment, u, v, who); left != 0; left &= left - 1) {
      const auto point = static_cast<std::size_t>(__builtin_ctzll(left));
      jobs.add(point, part, order, height_above(segment, v[point]).data(), 1, 0.0, 1.0);
    }
  }
  jobs.finish();
  return holding;
}

double turn_about_y(double x, double z) {
  const double squared = x * x + z * z;
  if (!(squared > kEpsilon)) return 0.0;
  const double angle = steady::arc_cosine(std::clamp(x / std::sqrt(squared), -1.0, 1.0));
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return (z < 0.0 ? kTurn - angle : angle) / kTurn;
}

}  // namespace firstlight::render
#endif
