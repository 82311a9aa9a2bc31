#include "render/shape/sphere_sweep.h"

#include "render/math/block_tests.h"
#include "render/math/box_tree.h"
#include "render/shape/placed.h"
#include "render/shape/sweep_segment.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/sphere_sweep.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/depth_roots-inl.h"
#include "render/shape/sweep_segment-inl.h"
#include "render/shape/through_sphere-inl.h"

#include <algorithm>
#include <array>
#include <optional>

#ifndef FIRSTLIGHT_RENDER_SHAPE_SPHERE_SWEEP
#define FIRSTLIGHT_RENDER_SHAPE_SPHERE_SWEEP
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

/// A crossing of the ray-th of some rays.
struct SweepCrossing {
  std::size_t ray;
  double depth;
  std::uint32_t face;
  double u;
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

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3& point, const Crossing& at) const {
    const SweepSegment& segment = segments[at.face / kPlaces];
    const auto from = [&](const SweepBall& ball) {
      const Vec3 step = point - ball.center;
      return ball.radius < 0.0 ? -step : step;
    };
    switch (at.face % kPlaces) {
      case kFirstBall:
        return from(segment.ball(0.0));
      case kLastBall:
        return from(segment.ball(1.0));
      case kFirstEnd:
        return -segment.slope(0.0).center;
      case kLastEnd:
        return segment.slope(1.0).center;
      default:
        return from(segment.ball(at.place[0]));
    }
  }
  Box3 bounds() const { return around; }
  Box3 given_bounds() const { return given; }
  Box3 inside_bounds() const { return around; }
};

/// A place where a ray goes through a surface that may lie within others.
struct Passage {
  double depth;
  std::uint32_t face;
  double u;
  bool enters;
};

/// Those of each ray of a block, in order: the nearest first, and of equally near ones the lower face. A thread keeps
/// them for the next time.
///
/// Source POV-Ray 3.7: all passages of the whole line, also of what lies behind the ray's origin; a counter of the
/// parts that the ray is in tells which are seen. The first and the last always are.
struct Passages {
  std::array<std::vector<Passage>, kRaysAtOnce> of;

  void clear(std::uint64_t who) {
    for (; who != 0; who &= who - 1) of[static_cast<std::size_t>(__builtin_ctzll(who))].clear();
  }
  void add(std::size_t ray, const Passage& passage) {
    std::vector<Passage>& list = of[ray];
    const auto before = [](const Passage& a, const Passage& b) {
      return a.depth < b.depth || (a.depth == b.depth && a.face < b.face);
    };
    list.insert(std::upper_bound(list.begin(), list.end(), passage, before), passage);
  }
  /// Calls visit(passage) for those that are seen, until it returns false.
  template <class Visit>
  void for_each_seen(std::size_t ray, const Visit& visit) const {
    const std::vector<Passage>& list = of[ray];
    int within = 1;
    for (std::size_t i = 0; i < list.size(); ++i) {
      bool is_seen = i == 0 || i + 1 == list.size();
      if (!is_seen) {
        is_seen = within == (list[i].enters ? 0 : 1);
        within += list[i].enters ? 1 : -1;
      }
      if (is_seen && !visit(list[i])) return;
    }
  }
};

/// A segment, and the rays that meet its box.
struct SegmentVisit {
  std::uint32_t segment;
  std::uint64_t rays;
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Adds the passages of those rays from the i-th on that are in `who` at `depth`, where the surface's normal is
/// `normal`.
template <class L>
HWY_INLINE void add_passages(const RayOf<L>& ray, std::size_t i, const MaskOf<L>& who, const L& depth,
                             std::uint32_t face, const L& u, const Vec3Of<L>& normal, Passages& passages) {
  const auto counts = who & (depth > -kMaxDistance) & (depth < kMaxDistance);
  std::uint64_t left = bits(counts);
  if (left == 0) return;
  const std::uint64_t entering = bits(dot(normal, ray.direction) < 0.0);
  double depths[L::kCount];
  double places[L::kCount];
  depth.store(depths);
  u.store(places);
  for (; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctzll(left));
    passages.add(i + lane, {depths[lane], face, places[lane], (entering >> lane & 1) != 0});
  }
}

template <class L>
HWY_INLINE Vec3Of<L> normal_of(const BallOf<L>& ball, const RayOf<L>& ray, const L& depth) {
  const Vec3Of<L> step = ray.origin + ray.direction * depth - ball.center;
  return select<L>(ball.radius < 0.0, -step, step);
}

/// The two passages through a ball.
template <class L>
HWY_INLINE void add_ball(const RayOf<L>& ray, std::size_t i, const MaskOf<L>& who, const BallOf<L>& ball,
                         std::uint32_t face, const L& u, Passages& passages) {
  const auto through = through_sphere(ray, ball.center, ball.radius * ball.radius);
  const auto met = who & through.met;
  if (!any(met)) return;
  add_passages(ray, i, met, through.enters, face, u, normal_of(ball, ray, through.enters), passages);
  add_passages(ray, i, met, through.leaves, face, u, normal_of(ball, ray, through.leaves), passages);
}

/// That through the flat circle at which the side of a segment ends, and its first or last ball goes on.
template <class L>
HWY_INLINE void add_end(const RayOf<L>& ray, std::size_t i, const MaskOf<L>& who, const SweepSegment& segment, double u,
                        std::uint32_t face, Passages& passages) {
  const SweepBall ball = segment.ball(u);
  const SweepBall slope = segment.slope(u);
  const Vec3Of<L> center = everywhere<L>(ball.center);
  const Vec3Of<L> along = everywhere<L>(slope.center);
  const L approach = dot(ray.direction, along);
  const L depth = -(dot(ray.origin - center, along) + ball.radius * slope.radius) / approach;
  const Vec3Of<L> from_center = ray.origin + ray.direction * depth - center;
  const auto met = who & (abs(approach) > kEpsilon) & (dot(from_center, from_center) < ball.radius * ball.radius);
  add_passages(ray, i, met, depth, face, L(u), u == 0.0 ? -along : along, passages);
}

/// Those of the side of a straight segment.
template <class L>
HWY_INLINE void add_straight_side(const RayOf<L>& ray, std::size_t i, const MaskOf<L>& who, const SweepSegment& segment,
                                  std::uint32_t face, Passages& passages) {
  const StraightTouches<L> touches = straight_touches(segment, ray);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto here = who & touches.places.counts[k];
    if (!any(here)) continue;
    const L& u = touches.places.root[k];
    const BallOf<L> ball = ball_at(segment, u);
    add_passages(ray, i, without(here, touches.is_across), touches.depth[k], face, u,
                 normal_of(ball, ray, touches.depth[k]), passages);
    const auto across = here & touches.is_across;
    if (any(across)) add_ball(ray, i, across, ball, face, u, passages);
  }
}

/// Finds the segments that whole lines meet, in their order: also those that lie behind the rays' origins.
void find_segments(const SphereSweep& sweep, const RayColumns& rays, std::uint64_t who,
                   std::vector<SegmentVisit>& visits) {
  const Vec3Of<Lanes> middle = everywhere<Lanes>(sweep.around.center());
  const double size = sweep.around.size().length();
  RayColumns lines;
  Columns3<double> inverse;
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    if ((who >> i & kAllLanes) == 0) continue;
    const auto origin = load3<Lanes>(rays.origin, i);
    const auto direction = load3<Lanes>(rays.direction, i);
    store3(origin - direction * (exact_length(middle - origin) + size), lines.origin, i);
    store3(direction, lines.direction, i);
    store3(finite_inverse(direction), inverse, i);
  }
  visits.clear();
  if (sweep.tree) {
    sweep.tree->for_each_met(lines, inverse, who, [&](std::uint32_t segment, std::uint64_t here) {
      visits.push_back({segment, here});
    });
    std::sort(visits.begin(), visits.end(),
              [](const SegmentVisit& a, const SegmentVisit& b) { return a.segment < b.segment; });
    return;
  }
  for (std::uint32_t segment = 0; segment < sweep.segments.size(); ++segment) {
    const std::uint64_t here = meeting(lines, inverse, sweep.boxes[segment], who);
    if (here != 0) visits.push_back({segment, here});
  }
}

void meet_sweep(const SphereSweep& sweep, const Transform& transform, const RayColumns& given, std::uint64_t who,
                const Column<double>* low, std::vector<SweepCrossing>& out) {
  thread_local Passages passages;
  thread_local std::vector<SegmentVisit> visits;
  passages.clear(who);
  RayColumns rays;
  Column<double> length;
  for_each_vector(transform, given, who, [&](const RayOf<Lanes>& ray, std::size_t i, std::uint64_t) HWY_ATTR {
    const UnitRayOf<Lanes> unit = unit_ray(ray);
    store3(unit.ray.origin, rays.origin, i);
    store3(unit.ray.direction, rays.direction, i);
    store(unit.length, length, i);
  });
  find_segments(sweep, rays, who, visits);
  const auto take = [&](std::size_t i, std::uint32_t segment, double u) {
    const Ray ray = rays.ray(i);
    add_ball(RayOf<One>{everywhere<One>(ray.origin), everywhere<One>(ray.direction)}, i, OneMask{true},
             ball_at(sweep.segments[segment], One(u)), SphereSweep::kPlaces * segment + SphereSweep::kSide, One(u),
             passages);
  };
  RootJobs jobs(take);
  RootJobs jobs_across(take);
  for (const SegmentVisit& visit : visits) {
    const SweepSegment& segment = sweep.segments[visit.segment];
    const std::uint32_t face = SphereSweep::kPlaces * visit.segment;
    for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
      const std::uint64_t of_vector = visit.rays >> i & kAllLanes;
      if (of_vector == 0) continue;
      const RayOf<Lanes> ray{load3<Lanes>(rays.origin, i), load3<Lanes>(rays.direction, i)};
      const auto here = Lanes::mask_of(static_cast<unsigned>(of_vector));
      add_ball(ray, i, here, everywhere<Lanes>(segment.ball(0.0)), face + SphereSweep::kFirstBall, Lanes(0.0),
               passages);
      if (visit.segment + 1 == sweep.segments.size()) {
        add_ball(ray, i, here, everywhere<Lanes>(segment.ball(1.0)), face + SphereSweep::kLastBall, Lanes(1.0),
                 passages);
      }
      add_end(ray, i, here, segment, 0.0, face + SphereSweep::kFirstEnd, passages);
      add_end(ray, i, here, segment, 1.0, face + SphereSweep::kLastEnd, passages);
      if (segment.order == 1) {
        add_straight_side(ray, i, here, segment, face + SphereSweep::kSide, passages);
        continue;
      }
      const CurvedTouches<Lanes> touches = curved_touches(segment, ray);
      const std::uint64_t across = bits(touches.is_across) & of_vector;
      const std::uint64_t others = of_vector & ~across & ~std::uint64_t{bits(touches.has_none)};
      if (others != 0) {
        add_jobs(jobs, i, others, visit.segment, 10, touches.equation.c, Lanes(0.0), Lanes(1.0));
      }
      if (across != 0) {
        add_jobs(jobs_across, i, across, visit.segment, 5, touches.equation_across.c, Lanes(0.0), Lanes(1.0));
      }
    }
  }
  jobs.finish();
  jobs_across.finish();
  for (std::uint64_t left = who; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
    passages.for_each_seen(i, [&](const Passage& passage) {
      const double depth = passage.depth / length[i];
      if (!(depth > sweep.tolerance)) return true;
      out.push_back({i, depth, passage.face, passage.u});
      return low == nullptr || !(depth > (*low)[i]);
    });
  }
}

std::uint64_t inside_sweep(const SphereSweep& sweep, const Transform& transform, const Columns3<double>& given,
                           std::uint64_t who) {
  Columns3<double> points;
  for_each_vector(transform, given, who,
                  [&](const Vec3Of<Lanes>& p, std::size_t i, std::uint64_t) HWY_ATTR { store3(p, points, i); });
  std::uint64_t held = 0;
  RootJobs jobs([&](std::size_t i, std::uint32_t, double) { held |= std::uint64_t{1} << i; });
  const auto look = [&](std::uint32_t index, std::uint64_t here, std::uint64_t left) HWY_ATTR {
    const SweepSegment& segment = sweep.segments[index];
    for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
      const std::uint64_t of_vector = here >> i & kAllLanes;
      if (of_vector == 0) continue;
      const auto p = load3<Lanes>(points, i);
      if (segment.order == 1) {
        const Powers<Lanes, 3> d = distance<1>(segment, p);
        const UnitRoots<Lanes> roots = quadratic_roots(d.c[2], d.c[1], d.c[0]);
        held |= (bits(roots.counts[0] | roots.counts[1]) & of_vector) << i;
        continue;
      }
      const Powers<Lanes, 7> d = distance<3>(segment, p);
      const std::uint64_t open = of_vector & ~std::uint64_t{bits(has_no_root(d))};
      if (open != 0) add_jobs(jobs, i, open, index, 6, d.c, Lanes(0.0), Lanes(1.0));
    }
    return left & ~held;
  };
  if (sweep.tree) {
    sweep.tree->for_each_around(points, who, look);
  } else {
    for (std::uint32_t index = 0; index < sweep.segments.size(); ++index) {
      look(index, within(points, sweep.boxes[index], who & ~held), who);
    }
  }
  jobs.finish();
  return held;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(meet_sweep);
HWY_EXPORT(inside_sweep);

/// Until the next call of this thread.
const std::vector<SweepCrossing>& crossings_of(const SphereSweep& sweep, const Transform& transform,
                                               const RayColumns& rays, std::uint64_t who, const Column<double>* low) {
  thread_local std::vector<SweepCrossing> found;
  found.clear();
  HWY_DYNAMIC_DISPATCH(meet_sweep)(sweep, transform, rays, who, low, found);
  return found;
}

void SphereSweep::meet(const Ray& ray, Met& met) const {
  const Column<double> low = alone(met.low());
  for (const SweepCrossing& crossing :
       crossings_of(*this, Transform(), alone(ray), 1, met.wants_all() ? nullptr : &low)) {
    met.add(crossing.depth, crossing.face, {crossing.u, 0.0});
  }
}

void SphereSweep::meet_block(const RaysAndPlace& asked, Slots& slots) const {
  SlotLists lists(asked.shape, slots, true);
  for (const SweepCrossing& crossing :
       crossings_of(*this, asked.transform, asked.rays, asked.who,
                    asked.nearest_only == nullptr ? nullptr : &asked.nearest_only->low)) {
    lists.add(crossing.ray, crossing.depth, crossing.face, {crossing.u, 0.0});
  }
}

std::uint64_t SphereSweep::inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                                        std::uint64_t who) const {
  const std::uint64_t held = HWY_DYNAMIC_DISPATCH(inside_sweep)(*this, transform, points, who);
  return inverted ? who & ~held : held;
}

bool SphereSweep::inside(const Vec3& point, bool inverted) const {
  const Columns3<double> points{alone(point.x), alone(point.y), alone(point.z)};
  return inside_block(Transform(), inverted, points, 1) != 0;
}

}  // namespace

ShapePtr make_sphere_sweep(const SphereSweepParameters& parameters) {
  return std::make_shared<Placed<SphereSweep>>(SphereSweep(parameters), Transform());
}

}  // namespace firstlight::render
#endif
