#include "render/shape/prism.h"

#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/prism.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/depth_roots-inl.h"
#include "render/shape/profile-inl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#ifndef FIRSTLIGHT_RENDER_SHAPE_PRISM
#define FIRSTLIGHT_RENDER_SHAPE_PRISM
namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-4;  ///< POV-Ray's for this shape
constexpr double kRoom = 1e-9;     ///< relative: the search goes this much beyond a segment's rectangle
constexpr double kFar = 1e100;     ///< half the size of a rectangle without end

constexpr std::uint32_t kBase = 0xfffffffeu;
constexpr std::uint32_t kCap = 0xffffffffu;

bool is_same(const Vec2& a, const Vec2& b) { return std::abs(a.x - b.x) < kEpsilon && std::abs(a.y - b.y) < kEpsilon; }

/// The segments of all curves; from a point that closes one to the first of the next there is none. [POV-Ray 3.7]
std::vector<ProfileSegment> segments_of(const PrismParameters& parameters) {
  const std::vector<Vec2>& points = parameters.points;
  const ProfileSpline spline = parameters.spline;
  std::vector<ProfileSegment> segments;
  if (spline == ProfileSpline::bezier) {
    const std::vector<Vec2> backwards(points.rbegin(), points.rend());  // as POV-Ray has them: it turns their normals
    for (std::size_t i = points.size(); i >= 4; i -= 4) {
      segments.push_back(profile_segment(spline, backwards, points.size() - i));
    }
    return segments;
  }
  const auto kind = static_cast<std::size_t>(spline);  // 0, 1, 2: how many points give directions
  const std::size_t ahead = kind == 0 ? 1 : 2;         // from the first point of a segment to where it ends
  std::size_t begin = kind == 0 ? 0 : 1;
  for (std::size_t i = 0; i + kind + 2 <= points.size(); ++i) {
    segments.push_back(profile_segment(spline, points, i));
    if (!is_same(points[i + ahead], points[std::min(begin, points.size() - 1)])) continue;
    i += kind + 1;
    begin = i + ahead;
  }
  return segments;
}

/// A rectangle in the plane of the curves.
struct Rectangle {
  Vec2 middle{0.0};
  Vec2 half{kFar};

  Rectangle() = default;
  Rectangle(const Vec2& low, const Vec2& high, double room)
      : middle((low + high) * 0.5), half((high - low) * 0.5 + Vec2(room)) {}
};

/// The swept curves in their own space. In the plane of the curves y stands for z.
struct Prism {
  static constexpr bool kIsLarge = true;
  using Sweep = PrismParameters::Sweep;

  std::vector<ProfileSegment> segments;
  std::vector<Rectangle> rectangles;  ///< about the segments, with room for rounding
  Vec2 low{kBoundless, kBoundless};   ///< a rectangle about the curves
  Vec2 high{-kBoundless, -kBoundless};
  std::size_t order;  ///< of the segments' equations
  double bottom;
  double top;
  Sweep sweep;
  bool open;

  double nearest = kNearest;
  bool turns_base = false;  ///< the base's normal points down

  explicit Prism(const PrismParameters& parameters) : Prism(segments_of(parameters), parameters) {}
  /// Takes from `parameters` only what is beside the curves.
  Prism(std::vector<ProfileSegment> curves, const PrismParameters& parameters)
      : segments(std::move(curves)),
        order(highest_order(segments)),
        bottom(parameters.low),
        top(parameters.high),
        sweep(parameters.sweep),
        open(parameters.open) {
    for (const ProfileSegment& segment : segments) {
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], segment.low[axis]);
        high[axis] = std::max(high[axis], segment.high[axis]);
      }
      rectangles.emplace_back(segment.low, segment.high, kRoom * (1.0 + size(segment.low) + size(segment.high)));
    }
  }

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& p, bool inverted) const {
    if (!(p.y >= bottom && p.y < top)) return inverted;
    const double size = sweep == Sweep::conic ? p.y : 1.0;
    if (!(std::abs(size) > kEpsilon)) return inverted;
    return holds(p.x / size, p.z / size) != inverted;
  }
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    if (at.face == kBase && turns_base) return Vec3(0.0, -1.0, 0.0);
    if (at.face == kBase || at.face == kCap) return Vec3(0.0, 1.0, 0.0);
    const Vec2 slope = segments[at.face].slope(at.place[0]);
    Vec3 n(slope.y, 0.0, -slope.x);
    if (sweep == Sweep::conic) {
      if (!(std::abs(p.y) > kEpsilon)) return Vec3(0.0, 1.0, 0.0);
      n.y = -(p.x * n.x + p.z * n.z) / p.y;
    }
    return n;
  }
  Box3 bounds() const {
    Box3 box;
    for (const double height : {bottom, top}) {
      const double size = sweep == Sweep::conic ? height : 1.0;
      box.extendBy(Vec3(low.x * size, height, low.y * size));
      box.extendBy(Vec3(high.x * size, height, high.y * size));
    }
    return box;
  }
  Box3 inside_bounds() const { return bounds(); }

  /// Whether the place in the plane of the curves is in them.
  bool holds(double u, double v) const {
    return u >= low.x && u <= high.x && v >= low.y && v <= high.y && is_in_curves(segments, u, v);
  }

 private:
  static double size(const Vec2& v) { return std::abs(v.x) + std::abs(v.y); }
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// As Rectangle.
template <class L>
struct RectangleOf {
  L middle[2];
  L half[2];
};

/// Whether it meets another, and its corners lie on both sides of the line u x + v y + w = 0.
template <class L>
HWY_INLINE MaskOf<L> meets(const Rectangle& here, const RectangleOf<L>& other, const Vec3Of<L>& line) {
  return (abs(here.middle.x - other.middle[0]) <= here.half.x + other.half[0]) &
         (abs(here.middle.y - other.middle[1]) <= here.half.y + other.half[1]) &
         (abs(line.x * here.middle.x + line.y * here.middle.y + line.z) <=
          abs(line.x) * here.half.x + abs(line.y) * here.half.y);
}

/// About what of the ray lies between the heights of the prism, in the plane of the curves.
template <class L>
HWY_INLINE RectangleOf<L> shadow_of(const Prism& prism, const RayOf<L>& ray) {
  const bool is_conic = prism.sweep == PrismParameters::Sweep::conic;
  if (is_conic && !(prism.bottom * prism.top > 0.0)) return {{0.0, 0.0}, {kFar, kFar}};
  const Vec3Of<L>& p = ray.origin;
  const Vec3Of<L>& d = ray.direction;
  const L t1 = (prism.bottom - p.y) / d.y;
  const L t2 = (prism.top - p.y) / d.y;
  L a[2] = {p.x + t1 * d.x, p.z + t1 * d.z};
  L b[2] = {p.x + t2 * d.x, p.z + t2 * d.z};
  L room = abs(p.x) + abs(p.z) + (abs(a[0]) + abs(a[1])) + (abs(b[0]) + abs(b[1]));
  if (is_conic) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      a[axis] = a[axis] / prism.bottom;
      b[axis] = b[axis] / prism.top;
    }
    room = room / std::min(std::abs(prism.bottom), std::abs(prism.top));
  }
  const L more = kRoom * (1.0 + room);
  const auto steep = abs(d.y) > kEpsilon;
  RectangleOf<L> shadow;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const L low = min(a[axis], b[axis]);
    const L high = max(a[axis], b[axis]);
    shadow.middle[axis] = select(steep, (low + high) * 0.5, L(0.0));
    shadow.half[axis] = select(steep, (high - low) * 0.5 + more, L(kFar));
  }
  return shadow;
}

/// A line in the plane of the curves: u x + v y + w = 0. Of a cone it is where the plane through the ray and the tip cuts
/// height 1.
template <class L>
HWY_INLINE Vec3Of<L> line_of(const Prism& prism, const RayOf<L>& ray) {
  const Vec3Of<L>& p = ray.origin;
  const Vec3Of<L>& d = ray.direction;
  if (prism.sweep == PrismParameters::Sweep::linear) return {d.z, -d.x, d.x * p.z - d.z * p.x};
  return {p.z * d.y - p.y * d.z, p.y * d.x - p.x * d.y, p.x * d.z - p.z * d.x};
}

/// The rays that may meet the prism's sides. Level ones pass above it, or below; others run along the sides.
template <class L>
HWY_INLINE MaskOf<L> may_meet_sides(const Prism& prism, const RayOf<L>& ray) {
  const Vec3Of<L>& p = ray.origin;
  const Vec3Of<L>& d = ray.direction;
  const auto beside = (abs(d.y) < kEpsilon) & ((p.y < prism.bottom) | (p.y > prism.top));
  return without((abs(d.x) > kEpsilon) | (abs(d.z) > kEpsilon), beside);
}

/// Where the rays come to a cap's height, as places in the plane of the curves. Returns those that may be in them.
template <class L>
HWY_INLINE MaskOf<L> places_on_cap(const Prism& prism, const RayOf<L>& ray, double height, L& t, L& u, L& v) {
  const Vec3Of<L>& p = ray.origin;
  const Vec3Of<L>& d = ray.direction;
  const double size = prism.sweep == PrismParameters::Sweep::conic ? height : 1.0;
  t = (height - p.y) / d.y;
  u = (p.x + t * d.x) / size;
  v = (p.z + t * d.z) / size;
  if (prism.open || !(std::abs(size) > kEpsilon)) return t < t;
  return without((t > prism.nearest) & (t < kMaxDistance), abs(d.y) < kEpsilon) & (u >= prism.low.x) &
         (u <= prism.high.x) & (v >= prism.low.y) & (v <= prism.high.y);
}

/// The distance of a segment's places from the line, in the curve's parameter.
template <class L>
HWY_INLINE void equation_of(const ProfileSegment& s, const Vec3Of<L>& line, L (&equation)[4]) {
  const auto along = [&](const Vec2& v) HWY_ATTR { return line.x * v.x + line.y * v.y; };
  equation[0] = along(s.d) + line.z;
  equation[1] = along(s.c);
  equation[2] = along(s.b);
  equation[3] = along(s.a);
}

/// Where rays meet the side above a place of a curve.
template <class L>
struct SideOf {
  L depth;  ///< along the rays as they were given
  MaskOf<L> is_met;
};

/// The side above the place `w` of a segment. `ray`: of unit length, and `length` the length it had.
template <class L>
HWY_INLINE SideOf<L> side_above(const Prism& prism, const ProfileSegment& segment, const L& w, const RayOf<L>& ray,
                                const L& length) {
  const Vec3Of<L>& p = ray.origin;
  const Vec3Of<L>& d = ray.direction;
  const PlaceOf<L> place = place_on(segment, w);
  L t;
  MaskOf<L> along;  // those that run along the side, which they do not meet
  if (prism.sweep == PrismParameters::Sweep::linear) {
    t = select(abs(d.x) > kEpsilon, (place.x - p.x) / d.x, (place.y - p.z) / d.z);
    along = t < t;
  } else {
    const L approach = d.x - place.x * d.y;
    const L other = d.z - place.y * d.y;
    const MaskOf<L> by_x = abs(approach) > kEpsilon;
    t = select(by_x, (place.x * p.y - p.x) / approach, (place.y * p.y - p.z) / other);
    along = !(by_x | (abs(other) > kEpsilon));
  }
  const L height = p.y + t * d.y;
  const L depth = t / length;
  return {depth,
          without((height >= prism.bottom) & (height <= prism.top) & (depth > prism.nearest) & (depth < kMaxDistance),
                  along)};
}

/// The sides above a segment that is a line or a parabola, met by those rays from the i-th on whose bits are in `here`.
HWY_INLINE void meet_few_sides(const Prism& prism, std::uint32_t part, const Lanes (&equation)[4],
                               const RayOf<Lanes>& ray, const Lanes& length, std::size_t i, std::uint64_t here,
                               SlotLists& lists) {
  const FewRoots<Lanes> roots = few_roots(equation, Lanes(0.0), Lanes(1.0));
  const auto add = [&](const Lanes& w, const LanesMask& has) HWY_ATTR {
    const std::uint64_t with_root = bits(has) & here;
    if (with_root == 0) return;
    const SideOf<Lanes> side = side_above(prism, prism.segments[part], w, ray, length);
    double depths[Lanes::kCount];
    double places[Lanes::kCount];
    side.depth.store(depths);
    w.store(places);
    for (std::uint64_t left = bits(side.is_met) & with_root; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctzll(left));
      lists.add(i + lane, depths[lane], part, {places[lane], 0.0});
    }
  };
  add(roots.first, roots.has_first);
  add(roots.second, roots.has_second);
}

void meet_prism(const Prism& prism, const RaysAndPlace& asked, Slots& slots) {
  RayColumns rays;
  Column<double> length;
  std::uint64_t sides = 0;
  struct Cap {
    double height;
    std::uint32_t face;
    std::uint64_t near;
    Column<double> t, u, v;
  };
  Cap caps[2];
  for (const bool is_top : {true, false}) {
    Cap& cap = caps[is_top ? 0 : 1];
    cap.height = is_top ? prism.top : prism.bottom;
    cap.face = is_top ? kCap : kBase;
    cap.near = 0;
  }
  for_each_vector(asked, [&](const RayOf<Lanes>& given, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
    const UnitRayOf<Lanes> unit = unit_ray(given);
    store3(unit.ray.origin, rays.origin, i);
    store3(unit.ray.direction, rays.direction, i);
    store(unit.length, length, i);
    sides |= (bits(may_meet_sides(prism, unit.ray)) & of_vector) << i;
    for (Cap& cap : caps) {
      Lanes t;
      Lanes u;
      Lanes v;
      cap.near |= (bits(places_on_cap(prism, unit.ray, cap.height, t, u, v)) & of_vector) << i;
      store(t, cap.t, i);
      store(u, cap.u, i);
      store(v, cap.v, i);
    }
  });
  SlotLists lists(asked.shape, slots, true);
  for (const Cap& cap : caps) {
    if (cap.near == 0) continue;
    for (std::uint64_t left = points_in_curves(prism.segments, cap.u, cap.v, cap.near); left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
      const double depth = cap.t[i] / length[i];
      if (depth > prism.nearest && depth < kMaxDistance) lists.add(i, depth, cap.face, {});
    }
  }
  if (sides == 0) return;
  RootJobs jobs([&](std::size_t i, std::uint32_t part, double w) {
    const Ray ray = rays.ray(i);
    const RayOf<One> same{everywhere<One>(ray.origin), everywhere<One>(ray.direction)};
    const SideOf<One> side = side_above<One>(prism, prism.segments[part], w, same, length[i]);
    if (side.is_met.holds) lists.add(i, side.depth.v, part, {w, 0.0});
  });
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    const std::uint64_t of_vector = sides >> i & kAllLanes;
    if (of_vector == 0) continue;
    const RayOf<Lanes> ray{load3<Lanes>(rays.origin, i), load3<Lanes>(rays.direction, i)};
    const Vec3Of<Lanes> line = line_of(prism, ray);
    const RectangleOf<Lanes> shadow = shadow_of(prism, ray);
    for (std::uint32_t part = 0; part < prism.segments.size(); ++part) {
      const std::uint64_t here = bits(meets(prism.rectangles[part], shadow, line)) & of_vector;
      if (here == 0) continue;
      Lanes equation[4];
      equation_of(prism.segments[part], line, equation);
      if (prism.order <= 2) {
        meet_few_sides(prism, part, equation, ray, load<Lanes>(length, i), i, here, lists);
      } else {
        add_jobs(jobs, i, here, part, prism.order, equation, Lanes(0.0), Lanes(1.0));
      }
    }
  }
  jobs.finish();
}

inline void meet_prism_once(const Prism& prism, const Ray& given, Met& met) {
  const auto [length, ray] = unit_ray(RayOf<One>{everywhere<One>(given.origin), everywhere<One>(given.direction)});
  for (const bool is_top : {true, false}) {
    One t;
    One u;
    One v;
    if (!places_on_cap(prism, ray, is_top ? prism.top : prism.bottom, t, u, v).holds) continue;
    const double depth = (t / length).v;
    if (depth > prism.nearest && depth < kMaxDistance && is_in_curves(prism.segments, u.v, v.v)) {
      met.add(depth, is_top ? kCap : kBase);
    }
  }
  if (!may_meet_sides(prism, ray).holds) return;
  const Vec3Of<One> line = line_of(prism, ray);
  const RectangleOf<One> shadow = shadow_of(prism, ray);
  for (std::uint32_t part = 0; part < prism.segments.size(); ++part) {
    if (!meets(prism.rectangles[part], shadow, line).holds) continue;
    One equation[4];
    equation_of(prism.segments[part], line, equation);
    const double c[4] = {equation[0].v, equation[1].v, equation[2].v, equation[3].v};
    PolynomialRoots roots({c, prism.order + 1}, 0.0, 1.0);
    for (double w; roots.next(w);) {
      const SideOf<One> side = side_above<One>(prism, prism.segments[part], w, ray, length);
      if (side.is_met.holds) met.add(side.depth.v, part, {w, 0.0});
    }
  }
}

std::uint64_t inside_prism(const Prism& prism, const Transform& transform, bool inverted,
                           const Columns3<double>& points, std::uint64_t who) {
  Column<double> us;
  Column<double> vs;
  std::uint64_t near = 0;
  for_each_vector(transform, points, who, [&](const Vec3Of<Lanes>& p, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
    const Lanes size = prism.sweep == PrismParameters::Sweep::conic ? p.y : Lanes(1.0);
    const Lanes u = p.x / size;
    const Lanes v = p.z / size;
    store(u, us, i);
    store(v, vs, i);
    const auto may = (p.y >= prism.bottom) & (p.y < prism.top) & (abs(size) > kEpsilon) & (u >= prism.low.x) &
                     (u <= prism.high.x) & (v >= prism.low.y) & (v <= prism.high.y);
    near |= (bits(may) & of_vector) << i;
  });
  const std::uint64_t holding = near == 0 ? 0 : points_in_curves(prism.segments, us, vs, near);
  return inverted ? who & ~holding : holding;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(meet_prism);
HWY_EXPORT(inside_prism);

void Prism::meet(const Ray& ray, Met& met) const { HWY_NAMESPACE::meet_prism_once(*this, ray, met); }

void Prism::meet_block(const RaysAndPlace& asked, Slots& slots) const {
  HWY_DYNAMIC_DISPATCH(meet_prism)(*this, asked, slots);
}

std::uint64_t Prism::inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                                  std::uint64_t who) const {
  return HWY_DYNAMIC_DISPATCH(inside_prism)(*this, transform, inverted, points, who);
}

}  // namespace

ShapePtr make_prism(const PrismParameters& parameters) {
  return std::make_shared<Placed<Prism>>(Prism(parameters), Transform());
}

ShapePtr make_letter(std::vector<ProfileSegment> outline, double thickness) {
  constexpr double kNearestOfText = 1e-6;  // POV-Ray's
  Prism letter(std::move(outline),
               {ProfileSpline::quadratic, PrismParameters::Sweep::linear, 0.0, thickness, {}, false});
  letter.nearest = kNearestOfText;
  letter.turns_base = true;
  const Mat4 upright(1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1);  // y and z change places
  return std::make_shared<Placed<Prism>>(std::move(letter), Transform(upright));
}

}  // namespace firstlight::render
#endif
