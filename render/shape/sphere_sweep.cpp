#include "render/shape/sphere_sweep.h"

#include "render/math/box_tree.h"
#include "render/shape/placed.h"
#include "render/shape/sphere.h"
#include "render/shape/sweep_segment.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace firstlight::render {
namespace {

constexpr std::size_t kFew = 6;    ///< segments that are asked one by one
constexpr double kBoxRoom = 1e-9;  ///< of the boxes of segments, relative
constexpr double kLeastRoom = 1e-9;

using Parameters = SphereSweepParameters;

/// The coefficients of a curve's powers by its balls.
using SplineMatrix = std::array<std::array<double, 4>, 4>;
constexpr SplineMatrix kCatmullRom = {
    {{0.0, 1.0, 0.0, 0.0}, {-0.5, 0.0, 0.5, 0.0}, {1.0, -2.5, 2.0, -0.5}, {-0.5, 1.5, -1.5, 0.5}}};
constexpr SplineMatrix kBSpline = {{{1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0},
                                    {-0.5, 0.0, 0.5, 0.0},
                                    {0.5, -1.0, 0.5, 0.0},
                                    {-1.0 / 6.0, 0.5, -0.5, 1.0 / 6.0}}};

std::vector<SweepSegment> segments_of(const Parameters& parameters) {
  const std::vector<SweepBall>& balls = parameters.balls;
  std::vector<SweepSegment> segments;
  if (parameters.spline == Parameters::Spline::linear) {
    for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
      segments.push_back(SweepSegment{{balls[i], balls[i + 1] + balls[i] * -1.0, {}, {}}, 1});
    }
    return segments;
  }
  const SplineMatrix& matrix = parameters.spline == Parameters::Spline::cubic ? kCatmullRom : kBSpline;
  for (std::size_t i = 0; i + 3 < balls.size(); ++i) {
    SweepSegment segment{{}, 3};
    for (std::size_t power = 0; power < 4; ++power) {
      for (std::size_t k = 0; k < 4; ++k) {
        segment.coefficients[power] = segment.coefficients[power] + balls[i + k] * matrix[power][k];
      }
    }
    segments.push_back(segment);
  }
  return segments;
}

/// A place where the ray goes through a surface that may lie within others.
struct Passage {
  double depth;
  std::uint32_t face;
  double u;
  bool enters;
};

struct SphereSweep {
  static constexpr bool kIsLarge = true;

  /// The part of a segment that is met. A crossing's face is kPlaces * segment + one of these.
  enum Place : std::uint32_t { kFirstBall, kLastBall, kFirstEnd, kLastEnd, kSide };
  static constexpr std::uint32_t kPlaces = 5;

  std::vector<SweepSegment> segments;
  std::vector<Box3> boxes;
  std::optional<BoxTree> tree;  ///< over the boxes; none of few
  Box3 around;
  Box3 given;
  double tolerance;

  explicit SphereSweep(const Parameters& parameters)
      : segments(segments_of(parameters)), tolerance(parameters.tolerance) {
    for (const SweepSegment& segment : segments) {
      boxes.push_back(padded(segment.bounds(), kBoxRoom, kLeastRoom));
      around.extendBy(boxes.back());
    }
    if (segments.size() > kFew) tree.emplace(boxes);
    // POV-Ray's box is made of the balls that the scene gives.
    const double part = parameters.spline == Parameters::Spline::cubic ? 2.0 : 1.0;
    given.min = Vec3(kBoundingHuge);
    given.max = Vec3(-kBoundingHuge);
    for (const SweepBall& ball : parameters.balls) {
      for (int axis = 0; axis < 3; ++axis) {
        given.min[axis] = std::min(given.min[axis], ball.center[axis] - part * ball.radius);
        given.max[axis] = std::max(given.max[axis], ball.center[axis] + part * ball.radius);
      }
    }
  }

  /// Source  POV-Ray 3.7: all passages of the whole line, also of what lies behind the ray's origin, in order; a counter
  ///         of the parts that the ray is in tells which are seen. The first and the last always are.
  void meet(const Ray& given_ray, Met& met) const {
    const auto [length, ray] = UnitRay(given_ray);
    thread_local std::vector<Passage> passages;
    passages.clear();
    for_each_met(ray, [&, &line = ray](std::uint32_t i) { add_passages(line, i, passages); });
    std::stable_sort(passages.begin(), passages.end(),
                     [](const Passage& a, const Passage& b) { return a.depth < b.depth; });
    int within = 1;
    for (std::size_t i = 0; i < passages.size(); ++i) {
      bool is_seen = i == 0 || i + 1 == passages.size();
      if (!is_seen) {
        is_seen = within == (passages[i].enters ? 0 : 1);
        within += passages[i].enters ? 1 : -1;
      }
      const double depth = passages[i].depth / length;
      if (is_seen && depth > tolerance) met.add(depth, passages[i].face, {passages[i].u, 0.0});
    }
  }
  bool inside(const Vec3& point, bool inverted) const {
    const auto holds = [&](std::uint32_t i) { return boxes[i].intersects(point) && segments[i].holds(point); };
    bool found = false;
    if (tree) {
      found = tree->any_around(point, holds);
    } else {
      for (std::uint32_t i = 0; i < segments.size() && !found; ++i) found = holds(i);
    }
    return found != inverted;
  }
  Vec3 normal(const Vec3& point, const Crossing& at) const { return normal(point, at.face, at.place[0]); }
  Box3 bounds() const { return around; }
  Box3 given_bounds() const { return given; }
  Box3 inside_bounds() const { return around; }

 private:
  Vec3 normal(const Vec3& point, std::uint32_t face, double u) const {
    const SweepSegment& segment = segments[face / kPlaces];
    const auto from = [&](const SweepBall& ball) {
      const Vec3 step = point - ball.center;
      return ball.radius < 0.0 ? -step : step;
    };
    switch (face % kPlaces) {
      case kFirstBall:
        return from(segment.ball(0.0));
      case kLastBall:
        return from(segment.ball(1.0));
      case kFirstEnd:
        return -segment.slope(0.0).center;
      case kLastEnd:
        return segment.slope(1.0).center;
      default:
        return from(segment.ball(u));
    }
  }

  /// Visits all whose box the line meets, in their order; also those behind the ray's origin.
  template <class Visit>
  void for_each_met(const Ray& ray, const Visit& visit) const {
    const Vec3 to_middle = around.center() - ray.origin;
    const Ray line{ray.at(-to_middle.length() - around.size().length()), ray.direction};
    if (!tree) {
      for (std::uint32_t i = 0; i < segments.size(); ++i) {
        if (meets(line, boxes[i])) visit(i);
      }
      return;
    }
    thread_local std::vector<std::uint32_t> found;
    found.clear();
    tree->met_by(line, found);
    std::sort(found.begin(), found.end());
    for (const std::uint32_t i : found) visit(i);
  }

  void add_passages(const Ray& ray, std::uint32_t index, std::vector<Passage>& passages) const {
    const SweepSegment& segment = segments[index];
    const auto add = [&](double depth, std::uint32_t part, double u) {
      if (!(depth > -kMaxDistance && depth < kMaxDistance)) return;
      const std::uint32_t face = kPlaces * index + part;
      passages.push_back({depth, face, u, normal(ray.at(depth), face, u).dot(ray.direction) < 0.0});
    };
    const auto add_ball = [&](const SweepBall& ball, std::uint32_t part, double u) {
      double enters;
      double leaves;
      if (!meet_sphere(ray, ball.center, ball.radius * ball.radius, enters, leaves)) return;
      add(enters, part, u);
      add(leaves, part, u);
    };
    add_ball(segment.ball(0.0), kFirstBall, 0.0);
    if (index + 1 == segments.size()) add_ball(segment.ball(1.0), kLastBall, 1.0);
    add_end(ray, segment, 0.0, kFirstEnd, add);
    add_end(ray, segment, 1.0, kLastEnd, add);
    std::array<double, SweepSegment::kMostRoots> roots;
    const std::size_t count = segment.touching(ray, roots);
    for (std::size_t i = 0; i < count; ++i) {
      double depth;
      if (segment.order == 1 && segment.straight_depth(ray, roots[i], depth)) {
        add(depth, kSide, roots[i]);
      } else {
        add_ball(segment.ball(roots[i]), kSide, roots[i]);
      }
    }
  }
  /// The flat circle at which the side of a segment ends, and its first or last ball goes on.
  template <class Add>
  static void add_end(const Ray& ray, const SweepSegment& segment, double u, Place part, const Add& add) {
    const SweepBall ball = segment.ball(u);
    const SweepBall slope = segment.slope(u);
    const double approach = ray.direction.dot(slope.center);
    if (!(std::abs(approach) > kEpsilon)) return;
    const double depth = -((ray.origin - ball.center).dot(slope.center) + ball.radius * slope.radius) / approach;
    if ((ray.at(depth) - ball.center).length2() < ball.radius * ball.radius) add(depth, part, u);
  }
};

}  // namespace

ShapePtr make_sphere_sweep(const SphereSweepParameters& parameters) {
  return std::make_shared<Placed<SphereSweep>>(SphereSweep(parameters), Transform());
}

}  // namespace firstlight::render
