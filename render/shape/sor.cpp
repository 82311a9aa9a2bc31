#include "render/shape/sor.h"

#include "render/shape/placed.h"
#include "render/shape/profile.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/sor.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/depth_roots-inl.h"

#include <algorithm>
#include <array>
#include <cmath>

#ifndef FIRSTLIGHT_RENDER_SHAPE_SOR
#define FIRSTLIGHT_RENDER_SHAPE_SOR
namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-4;  ///< POV-Ray's for this shape; a cap of a smaller squared radius is left out
constexpr double kRoom = 1e-9;     ///< relative: the search goes this much beyond a segment's height

constexpr std::uint32_t kBase = 0xfffffffeu;
constexpr std::uint32_t kCap = 0xffffffffu;

/// The square of the radius at height y is ((a y + b) y + c) y + d.
struct Segment {
  double low;
  double high;
  double a, b, c, d;

  double squared_radius(double y) const { return ((a * y + b) * y + c) * y + d; }
  double slope(double y) const { return (3.0 * a * y + 2.0 * b) * y + c; }
};

/// Between p[1] and p[2], with the slopes that p[0] and p[3] give. [POV-Ray 3.7]
Segment segment_of(const Vec2* p) {
  const double value0 = p[1].x * p[1].x;
  const double value1 = p[2].x * p[2].x;
  const double slope0 = 2.0 * p[1].x * (p[2].x - p[0].x) / (p[2].y - p[0].y);
  const double slope1 = 2.0 * p[2].x * (p[3].x - p[1].x) / (p[3].y - p[1].y);
  const double start = p[1].y;
  const double height = p[2].y - start;
  // In t = y - start: value0 + slope0 t + square t^2 + cube t^3.
  const double rise = (value1 - value0) / height;
  const double square = (3.0 * rise - 2.0 * slope0 - slope1) / height;
  const double cube = (slope0 + slope1 - 2.0 * rise) / (height * height);
  Segment segment{start,
                  p[2].y,
                  cube,
                  square - 3.0 * cube * start,
                  slope0 - 2.0 * square * start + 3.0 * cube * start * start,
                  value0 - slope0 * start + square * start * start - cube * start * start * start};
  for (double* number : {&segment.a, &segment.b, &segment.c, &segment.d}) {
    if (std::abs(*number) < kEpsilon) *number = 0.0;
  }
  return segment;
}

/// The turned curve in its own space.
struct Sor {
  static constexpr bool kIsLarge = true;

  std::vector<Segment> segments;
  double radius = 0.0;
  double base_squared = 0.0;  ///< radii of the caps
  double cap_squared = 0.0;
  bool open = false;

  explicit Sor(const SorParameters& parameters) : open(parameters.open) {
    const std::vector<Vec2>& points = parameters.points;
    for (std::size_t i = 0; i + 4 <= points.size(); ++i) {
      const Segment& segment = segments.emplace_back(segment_of(points.data() + i));
      radius = std::max({radius, points[i + 1].x, points[i + 2].x});
      include_turns(segment);
    }
    base_squared = std::max(0.0, segments.front().squared_radius(low()));
    cap_squared = std::max(0.0, segments.back().squared_radius(high()));
  }

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3& p, const Crossing& at) const {
    if (at.face == kBase) return Vec3(0.0, -1.0, 0.0);
    if (at.face == kCap) return Vec3(0.0, 1.0, 0.0);
    return Vec3(p.x, -0.5 * segments[at.face].slope(p.y), p.z);
  }
  Vec2 uv(const Vec3& p, const Crossing& at) const {
    const double u = turn_about_y(p.x, p.z);
    const double from_axis = std::sqrt(p.x * p.x + p.z * p.z);
    if (at.face == kBase) return Vec2(u, from_axis / std::sqrt(base_squared) - 1.0);
    if (at.face == kCap) return Vec2(u, 2.0 - from_axis / std::sqrt(cap_squared));
    const Segment& segment = segments[at.face];
    const double share = 1.0 / static_cast<double>(segments.size());
    return Vec2(u, (p.y - segment.low) / (segment.high - segment.low) * share + static_cast<double>(at.face) * share);
  }
  Box3 bounds() const { return Box3(Vec3(-radius, low(), -radius), Vec3(radius, high(), radius)); }
  Box3 inside_bounds() const { return bounds(); }

  double low() const { return segments.front().low; }
  double high() const { return segments.back().high; }

 private:
  /// Where the curve is farthest from the axis between its points.
  void include_turns(const Segment& s) {
    const double b = s.b;
    const double a = 3.0 * s.a;
    std::array<double, 2> turns{s.low, s.low};
    if (std::abs(a) < kEpsilon) {
      if (b != 0.0) turns[0] = -0.5 * s.c / b;
    } else if (b * b - a * s.c >= 0.0) {
      const double root = std::sqrt(b * b - a * s.c);
      turns = {(-b + root) / a, (-b - root) / a};
    }
    for (const double y : turns) {
      if (y >= s.low && y <= s.high) radius = std::max(radius, std::sqrt(std::max(0.0, s.squared_radius(y))));
    }
  }
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
struct RayBySor : NearRay<L> {
  L from, to;  ///< where it is in the cylinder about the shape: not above each other where it is not
};

template <class L>
HWY_INLINE RayBySor<L> ray_by(const Sor& sor, const RayOf<L>& given) {
  const NearRay<L> ray = near_ray(unit_ray(given));
  const auto& [p, d, skipped, length] = ray;
  const L r = d.x * d.x + d.z * d.z;
  const L m = p.x * d.x + p.z * d.z;
  const L q = p.x * p.x + p.z * p.z;
  const double reach = sor.radius * (1.0 + kRoom) + kRoom;
  const L root = sqrt(m * m - r * (q - reach * reach));  // no number where it passes by
  const auto across = r > kEpsilon;
  return {ray, select(across, (-m - root) / r, L(-kBoundingHuge)), select(across, (-m + root) / r, L(kBoundingHuge))};
}

template <class L>
HWY_INLINE L depth_at(const NearRay<L>& ray, const L& t, MaskOf<L>& counts) {
  const L depth = (t + ray.skipped) / ray.length;
  counts = (depth > kNearest) & (depth < kMaxDistance);
  return depth;
}

/// met(k, depth, mask, face) for the two caps, as render/shape/lane_shape-inl.h says.
template <class L, class Sink>
HWY_INLINE void meet_caps(const Sor& sor, const RayBySor<L>& ray, const Sink& met) {
  if (sor.open) return;
  const Vec3Of<L>& p = ray.p;
  const Vec3Of<L>& d = ray.d;
  const auto meet_cap = [&](std::size_t k, double height, double squared, std::uint32_t face) HWY_ATTR {
    if (!(squared > kNearest)) return;
    const L t = (height - p.y) / d.y;
    const L x = p.x + t * d.x;
    const L z = p.z + t * d.z;
    MaskOf<L> counts;
    const L depth = depth_at(ray, t, counts);
    met(k, depth, counts & (x * x + z * z <= squared) & (abs(d.y) > kEpsilon), face);
  };
  meet_cap(0, sor.low(), sor.base_squared, kBase);
  meet_cap(1, sor.high(), sor.cap_squared, kCap);
}

/// The equation of a ray and a segment in the ray's depth, and where its roots are looked for: low < high where there may be
/// some.
template <class L>
HWY_INLINE void equation_of(const Segment& s, const RayBySor<L>& ray, L (&equation)[4], L& low, L& high) {
  const Vec3Of<L>& p = ray.p;
  const Vec3Of<L>& d = ray.d;
  const auto steep = abs(d.y) > kEpsilon;
  const auto rises = d.y > 0.0;
  const L room = kRoom * (1.0 + std::abs(s.low) + std::abs(s.high)) / abs(d.y);
  low = select(steep, max(ray.from, (select(rises, L(s.low), L(s.high)) - p.y) / d.y - room), ray.from);
  high = select(steep, min(ray.to, (select(rises, L(s.high), L(s.low)) - p.y) / d.y + room), ray.to);
  high = select(without((p.y < s.low) | (p.y > s.high), steep), low, high);
  const L r = d.x * d.x + d.z * d.z;
  const L m = p.x * d.x + p.z * d.z;
  const L q = p.x * p.x + p.z * p.z;
  equation[0] = p.y * (p.y * (s.a * p.y + s.b) + s.c) + s.d - q;
  equation[1] = d.y * (p.y * (3.0 * s.a * p.y + 2.0 * s.b) + s.c) - 2.0 * m;
  equation[2] = d.y * d.y * (3.0 * s.a * p.y + s.b) - r;
  equation[3] = s.a * d.y * d.y * d.y;
}

/// The highest power in a segment's equation: the quadric of a straight profile, and of a cone, has no cube.
HWY_INLINE std::size_t order_of(const Segment& s) { return s.a == 0.0 ? 2 : 3; }

void meet_sor(const Sor& sor, const RaysAndPlace& asked, Slots& slots) {
  Columns3<double> ps;
  Columns3<double> ds;
  Column<double> skipped;
  Column<double> length;
  Column<double> from;
  Column<double> to;
  SlotLists lists(asked.shape, slots, true);
  for_each_vector(asked, [&](const RayOf<Lanes>& given, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
    const RayBySor<Lanes> ray = ray_by(sor, given);
    store3(ray.p, ps, i);
    store3(ray.d, ds, i);
    store(ray.skipped, skipped, i);
    store(ray.length, length, i);
    store(ray.from, from, i);
    store(ray.to, to, i);
    meet_caps(sor, ray, SlotListSink{lists, i, of_vector});
  });
  RootJobs jobs([&](std::size_t i, std::uint32_t part, double t) {
    const double height = ps.of[1][i] + t * ds.of[1][i];
    const double depth = (t + skipped[i]) / length[i];
    if (height >= sor.segments[part].low && height <= sor.segments[part].high && depth > kNearest &&
        depth < kMaxDistance) {
      lists.add(i, depth, part, {});
    }
  });
  for (std::uint32_t part = 0; part < sor.segments.size(); ++part) {
    for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
      const std::uint64_t of_vector = asked.who >> i & kAllLanes;
      if (of_vector == 0) continue;
      const RayBySor<Lanes> ray{
          {load3<Lanes>(ps, i), load3<Lanes>(ds, i), load<Lanes>(skipped, i), load<Lanes>(length, i)},
          load<Lanes>(from, i),
          load<Lanes>(to, i)};
      Lanes equation[4];
      Lanes low;
      Lanes high;
      equation_of(sor.segments[part], ray, equation, low, high);
      add_jobs(jobs, i, of_vector, part, order_of(sor.segments[part]), equation, low, high);
    }
  }
  jobs.finish();
}

inline void meet_sor_once(const Sor& sor, const Ray& given, Met& met) {
  const auto ray = ray_by(sor, RayOf<One>{everywhere<One>(given.origin), everywhere<One>(given.direction)});
  meet_caps(sor, ray, ListSink<Met>{met});
  for (std::uint32_t part = 0; part < sor.segments.size(); ++part) {
    const Segment& segment = sor.segments[part];
    One equation[4];
    One low;
    One high;
    equation_of(segment, ray, equation, low, high);
    const double c[4] = {equation[0].v, equation[1].v, equation[2].v, equation[3].v};
    PolynomialRoots roots({c, order_of(segment) + 1}, low.v, high.v);
    for (double t; roots.next(t);) {
      const One height = ray.p.y + t * ray.d.y;
      OneMask counts;
      const One depth = depth_at(ray, One(t), counts);
      if (height.v >= segment.low && height.v <= segment.high && counts.holds) met.add(depth.v, part);
    }
  }
}

template <class L>
HWY_INLINE MaskOf<L> inside(const Sor& sor, const Vec3Of<L>& p, bool inverted) {
  const L squared = p.x * p.x + p.z * p.z;
  auto holding = p.y < p.y;
  auto open = squared <= sor.radius * sor.radius;
  for (const Segment& s : sor.segments) {
    const auto beside = without(open, (p.y < s.low) | (p.y > s.high));
    if (!any(beside)) continue;
    holding = holding | (beside & (squared <= ((s.a * p.y + s.b) * p.y + s.c) * p.y + s.d));
    open = without(open, beside);
  }
  return inverted ? !holding : holding;
}

FIRSTLIGHT_INSIDE_KERNEL(Sor)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(meet_sor);
FIRSTLIGHT_INSIDE_MEMBERS(Sor)

void Sor::meet(const Ray& ray, Met& met) const { HWY_NAMESPACE::meet_sor_once(*this, ray, met); }

void Sor::meet_block(const RaysAndPlace& asked, Slots& slots) const {
  HWY_DYNAMIC_DISPATCH(meet_sor)(*this, asked, slots);
}

}  // namespace

ShapePtr make_sor(const SorParameters& parameters) {
  return std::make_shared<Placed<Sor>>(Sor(parameters), Transform());
}

}  // namespace firstlight::render
#endif
