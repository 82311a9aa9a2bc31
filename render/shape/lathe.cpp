#include "render/shape/lathe.h"

#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/lathe.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/depth_roots-inl.h"

#include <algorithm>
#include <array>
#include <cmath>

#ifndef FIRSTLIGHT_RENDER_SHAPE_LATHE
#define FIRSTLIGHT_RENDER_SHAPE_LATHE
namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-4;  ///< POV-Ray's for this shape
constexpr double kLevel = 1e-7;    ///< the sine of rays that run level, to within rounding
constexpr double kRoom = 1e-9;     ///< relative: the search goes this much beyond a segment's bounds

/// The turned curve in its own space.
struct Lathe {
  static constexpr bool kIsLarge = true;

  std::vector<ProfileSegment> segments;
  std::size_t order = 1;  ///< highest of the segments
  Vec2 low{kBoundless, kBoundless};
  Vec2 high{-kBoundless, -kBoundless};

  explicit Lathe(const LatheParameters& parameters) {
    const std::size_t points = parameters.points.size();
    const auto add = [&](std::size_t first) {
      const ProfileSegment& segment =
          segments.emplace_back(profile_segment(parameters.spline, parameters.points, first));
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], segment.low[axis]);
        high[axis] = std::max(high[axis], segment.high[axis]);
      }
    };
    if (parameters.spline == ProfileSpline::bezier) {
      for (std::size_t i = 0; i + 4 <= points; i += 4) add(i);
    } else {
      const std::size_t needed = static_cast<std::size_t>(parameters.spline) + 2;
      for (std::size_t i = 0; i + needed <= points; ++i) add(i);
    }
    order = highest_order(segments);
  }

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& p, bool inverted) const {
    const double radius = std::sqrt(p.x * p.x + p.z * p.z);
    const bool is_near = p.y >= low.y && p.y <= high.y && radius <= high.x;
    return (is_near && is_in_curves(segments, radius, p.y)) != inverted;
  }
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    const double squared = p.x * p.x + p.z * p.z;
    if (!(squared > kEpsilon)) return Vec3(0.0, 1.0, 0.0);
    const Vec2 slope = segments[at.face].slope(at.place[0]);
    return Vec3(slope.y * p.x, -slope.x * std::sqrt(squared), slope.y * p.z);
  }
  Vec2 uv(const Vec3& p, const Crossing& at) const {
    const double along = (at.place[0] + static_cast<double>(at.face)) / static_cast<double>(segments.size());
    return Vec2(turn_about_y(p.x, p.z), std::min(along, 1.0));
  }
  Box3 bounds() const { return Box3(Vec3(-high.x, low.y, -high.x), Vec3(high.x, high.y, high.x)); }
  Box3 inside_bounds() const { return bounds(); }
};

/// A NearRay (render/shape/depth_roots-inl.h) of a block.
struct StoredRay {
  Vec3 p, d;
  double skipped;
  double length;
};

/// add(depth, face, place) for what of the ray meets the segment's curve at `w`.
template <class Add>
void add_crossings(const Lathe& lathe, const StoredRay& ray, std::uint32_t index, double w, const Add& add) {
  const Vec3& p = ray.p;
  const Vec3& d = ray.d;
  const ProfileSegment& segment = lathe.segments[index];
  const auto add_at = [&](double t) {
    const double depth = (t + ray.skipped) / ray.length;
    if (depth > kNearest && depth < kMaxDistance) add(depth, index, std::array<double, 2>{w, 0.0});
  };
  if (!(std::abs(d.y) < kLevel)) return add_at((segment.at(w).y - p.y) / d.y);
  const double r = d.x * d.x + d.z * d.z;
  const double m = d.x * p.x + d.z * p.z;
  const double radius = segment.at(w).x;
  const double discriminant = m * m - r * (p.x * p.x + p.z * p.z - radius * radius);
  if (!(discriminant >= 0.0) || r == 0.0) return;
  const double root = std::sqrt(discriminant);
  add_at((-m + root) / r);
  add_at((-m - root) / r);
}

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Whether a ray comes between the heights and distances from the axis of a rectangle that is turned.
template <class L>
HWY_INLINE MaskOf<L> reaches(const NearRay<L>& ray, const Vec2& low, const Vec2& high) {
  const Vec3Of<L>& p = ray.p;
  const Vec3Of<L>& d = ray.d;
  const double room = kRoom * (1.0 + std::max(std::abs(low.y), std::abs(high.y)) + high.x);
  const auto steep = abs(d.y) > kEpsilon;
  const auto rises = d.y > 0.0;
  const L more = room / abs(d.y);
  const L from = select(steep, (select(rises, L(low.y), L(high.y)) - p.y) / d.y - more, L(-kBoundingHuge));
  const L to = select(steep, (select(rises, L(high.y), L(low.y)) - p.y) / d.y + more, L(kBoundingHuge));
  const auto beside = without((p.y < low.y - room) | (p.y > high.y + room), steep);
  const L across = d.x * d.x + d.z * d.z;
  const L nearest = select(across > 0.0, -(p.x * d.x + p.z * d.z) / across, L(0.0));
  const auto squared = [&](const L& t) HWY_ATTR {
    const L x = p.x + t * d.x;
    const L z = p.z + t * d.z;
    return x * x + z * z;
  };
  const double outer = high.x + room;
  const double inner = std::max(0.0, low.x - room);
  const L within = select(nearest < from, from, select(to < nearest, to, nearest));
  return without((squared(within) <= outer * outer) & (max(squared(from), squared(to)) >= inner * inner), beside);
}

/// The equation of a ray and a segment, in the parameter of the curve.
///
/// On the ray y = p.y + t d.y, and the square of the distance from the axis is r t^2 + 2 m t + q. With t from the curve's
/// height it must be the curve's: r (y - p.y)^2 + 2 m d.y (y - p.y) + d.y^2 (q - x^2) = 0. A level ray stays at its
/// height: what is left of the equation is the square of the curve's height above it.
template <class L>
HWY_INLINE void equation_of(const ProfileSegment& s, const NearRay<L>& ray, L (&equation)[7]) {
  const Vec3Of<L>& p = ray.p;
  const Vec3Of<L>& d = ray.d;
  const L r = d.x * d.x + d.z * d.z;
  const L m = d.x * p.x + d.z * p.z;
  const L q = p.x * p.x + p.z * p.z;
  const L dy2 = d.y * d.y;
  const double x[4] = {s.d.x, s.c.x, s.b.x, s.a.x};
  const L y[4] = {s.d.y - p.y, s.c.y, s.b.y, s.a.y};
  for (L& c : equation) c = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) equation[i + k] = equation[i + k] + (r * y[i] * y[k] - dy2 * x[i] * x[k]);
    equation[i] = equation[i] + 2.0 * m * d.y * y[i];
  }
  equation[0] = equation[0] + dy2 * q;
  const auto is_level = abs(d.y) < kLevel;
  if (!any(is_level)) return;
  for (std::size_t i = 0; i < 7; ++i) equation[i] = select(is_level, i < 4 ? y[i] : L(0.0), equation[i]);
}

void meet_lathe(const Lathe& lathe, const RaysAndPlace& asked, Slots& slots) {
  Columns3<double> ps;
  Columns3<double> ds;
  Column<double> skipped;
  Column<double> length;
  std::uint64_t near = 0;
  for_each_vector(asked, [&](const RayOf<Lanes>& given, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
    const NearRay<Lanes> ray = near_ray(unit_ray(given));
    store3(ray.p, ps, i);
    store3(ray.d, ds, i);
    store(ray.skipped, skipped, i);
    store(ray.length, length, i);
    near |= (bits(reaches(ray, lathe.low, lathe.high)) & of_vector) << i;
  });
  SlotLists lists(asked.shape, slots, true);
  RootJobs jobs([&](std::size_t i, std::uint32_t part, double w) {
    add_crossings(lathe, {ps.vector(i), ds.vector(i), skipped[i], length[i]}, part, w,
                  [&](double depth, std::uint32_t face, const std::array<double, 2>& place) {
                    lists.add(i, depth, face, place);
                  });
  });
  for (std::uint32_t part = 0; near != 0 && part < lathe.segments.size(); ++part) {
    const ProfileSegment& segment = lathe.segments[part];
    for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
      if ((near >> i & kAllLanes) == 0) continue;
      const NearRay<Lanes> ray{load3<Lanes>(ps, i), load3<Lanes>(ds, i), load<Lanes>(skipped, i),
                               load<Lanes>(length, i)};
      const std::uint64_t here = near >> i & bits(reaches(ray, segment.low, segment.high));
      if (here == 0) continue;
      Lanes equation[7];
      equation_of(segment, ray, equation);
      add_jobs(jobs, i, here, part, 2 * lathe.order, equation, Lanes(0.0), Lanes(1.0));
    }
  }
  jobs.finish();
}

inline void meet_lathe_once(const Lathe& lathe, const Ray& given, Met& met) {
  const auto ray = near_ray(unit_ray(RayOf<One>{everywhere<One>(given.origin), everywhere<One>(given.direction)}));
  if (!reaches(ray, lathe.low, lathe.high).holds) return;
  const StoredRay same{Vec3(ray.p.x.v, ray.p.y.v, ray.p.z.v), Vec3(ray.d.x.v, ray.d.y.v, ray.d.z.v), ray.skipped.v,
                       ray.length.v};
  for (std::uint32_t part = 0; part < lathe.segments.size(); ++part) {
    const ProfileSegment& segment = lathe.segments[part];
    if (!reaches(ray, segment.low, segment.high).holds) continue;
    One equation[7];
    equation_of(segment, ray, equation);
    double c[7];
    for (std::size_t i = 0; i < 7; ++i) c[i] = equation[i].v;
    PolynomialRoots roots({c, 2 * lathe.order + 1}, 0.0, 1.0);
    for (double w; roots.next(w);) {
      add_crossings(lathe, same, part, w, [&](double depth, std::uint32_t face, const std::array<double, 2>& place) {
        met.add(depth, face, place);
      });
    }
  }
}

std::uint64_t inside_lathe(const Lathe& lathe, const Transform& transform, bool inverted,
                           const Columns3<double>& points, std::uint64_t who) {
  Column<double> radius;
  Column<double> height;
  std::uint64_t near = 0;
  for_each_vector(transform, points, who, [&](const Vec3Of<Lanes>& p, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
    const Lanes from_axis = sqrt(p.x * p.x + p.z * p.z);
    store(from_axis, radius, i);
    store(p.y, height, i);
    const auto may = (p.y >= lathe.low.y) & (p.y <= lathe.high.y) & (from_axis <= lathe.high.x);
    near |= (bits(may) & of_vector) << i;
  });
  const std::uint64_t holding = near == 0 ? 0 : points_in_curves(lathe.segments, radius, height, near);
  return inverted ? who & ~holding : holding;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(meet_lathe);
HWY_EXPORT(inside_lathe);

void Lathe::meet(const Ray& ray, Met& met) const { HWY_NAMESPACE::meet_lathe_once(*this, ray, met); }

void Lathe::meet_block(const RaysAndPlace& asked, Slots& slots) const {
  HWY_DYNAMIC_DISPATCH(meet_lathe)(*this, asked, slots);
}

std::uint64_t Lathe::inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                                  std::uint64_t who) const {
  return HWY_DYNAMIC_DISPATCH(inside_lathe)(*this, transform, inverted, points, who);
}

}  // namespace

ShapePtr make_lathe(const LatheParameters& parameters) {
  return std::make_shared<Placed<Lathe>>(Lathe(parameters), Transform());
}

}  // namespace firstlight::render
#endif
