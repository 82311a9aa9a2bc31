#include "render/shape/julia_fractal.h"

#include "render/math/interrupt.h"
#include "render/shape/placed.h"
#include "render/shape/slots.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/julia_fractal.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/hypercomplex-inl.h"
#include "render/shape/lane_shape-inl.h"
#include "render/shape/through_sphere-inl.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#ifndef FIRSTLIGHT_RENDER_SHAPE_JULIA_FRACTAL
#define FIRSTLIGHT_RENDER_SHAPE_JULIA_FRACTAL
namespace firstlight::render {
namespace {

// POV-Ray's, as all that follows.
constexpr double kTolerance = 1e-7;  ///< of a point of the surface
constexpr double kLeastSlope = 1e-8;
constexpr double kLongestStep = 30.0;  ///< of hypercomplex sets, in units of the least
/// The most steps of one ray. A step can be so short that a depth does not feel it.
constexpr double kMostSteps = 1e6;
constexpr int kIterationsBetween = 100'000;  ///< questions whether the work is still wanted

/// The set in its own space.
struct JuliaFractal {
  JuliaFractalParameters p;
  double radius;      ///< of a ball that holds it
  double exit_value;  ///< the square of the size from which on a value is out

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3&, const Crossing& at) const {
    const double x = at.place[0];
    const double y = at.place[1];
    const double z = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
    return Vec3(x, y, at.face == 1 ? -z : z);
  }
  Box3 bounds() const { return Box3(Vec3(-radius), Vec3(radius)); }
  Box3 inside_bounds() const { return mistakes_z() ? boundless_box() : bounds(); }
  /// POV-Ray asks whether a point is inside of some sets at (x, y, y), while it looks for the surface at (x, y, z).
  bool mistakes_z() const {
    return p.algebra == JuliaFractalParameters::Algebra::hypercomplex && p.function != JuliaFunction::square &&
           p.function != JuliaFunction::cube && p.function != JuliaFunction::reciprocal;
  }
};

/// Room for an orbit: all that an iteration comes through, the starting point first.
double* orbit_of_thread(std::size_t numbers) {
  thread_local std::vector<double> orbit;
  if (orbit.size() < numbers) orbit.resize(numbers);
  return orbit.data();
}

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

// Values of the orbits of several points side by side.

template <class L>
HWY_INLINE Vec4Of<L> value_at(const double* orbit, std::size_t i) {
  const double* at = orbit + 4 * L::kCount * i;
  return {L::load(at), L::load(at + L::kCount), L::load(at + 2 * L::kCount), L::load(at + 3 * L::kCount)};
}
/// Those that are not in `who` stay.
template <class L>
HWY_INLINE void keep_value(const Vec4Of<L>& q, const MaskOf<L>& who, double* orbit, std::size_t i) {
  double* at = orbit + 4 * L::kCount * i;
  const Vec4Of<L> kept = all(who) ? q : select(who, q, value_at<L>(orbit, i));
  kept.x.store(at);
  kept.y.store(at + L::kCount);
  kept.z.store(at + 2 * L::kCount);
  kept.w.store(at + 3 * L::kCount);
}

template <class L>
HWY_INLINE L square_length(const Vec4Of<L>& q) {
  return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}

// Rules of iteration. Each has `square_of`, the square of a value's size; `next_value`, the value behind `q` without the
// set's parameter; `distance`, the length that a ray may step without leaving a side of the surface, from an orbit that
// left the set at value `last`; and `growth`, the direction in which value `last` of an orbit grows, as far as the slice
// goes.
//
// All sums are in POV-Ray's order. A step hangs on the one before it, so what is rounded in another way grows until
// points of the surface are elsewhere by as much as decides whether a feeler begins inside or outside.

/// q^2 and q^3 of quaternions.
template <int kPower>
struct QuaternionPower {};

template <int kPower, class L>
HWY_INLINE L square_of(QuaternionPower<kPower>, const Vec4Of<L>& q) {
  return q.y * q.y + q.z * q.z + q.w * q.w + q.x * q.x;
}
template <int kPower, class L>
HWY_INLINE Vec4Of<L> next_value(QuaternionPower<kPower>, const Vec4Of<L>& q, const Vec4Of<L>&) {
  const L d = q.y * q.y + q.z * q.z + q.w * q.w;
  const L x2 = q.x * q.x;
  if constexpr (kPower == 2) {
    const L x = 2.0 * q.x;
    return {x2 - d, x * q.y, x * q.z, x * q.w};
  } else {
    const L f = 3.0 * x2 - d;
    return {q.x * (x2 - 3.0 * d), q.y * f, q.z * f, q.w * f};
  }
}
/// The product of two quaternions, with k j = i; for cubes with the sums in another order.
template <int kPower, class L>
HWY_INLINE Vec4Of<L> quaternion_product(QuaternionPower<kPower>, const Vec4Of<L>& a, const Vec4Of<L>& b) {
  if constexpr (kPower == 2) {
    return {a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w, a.x * b.y + a.y * b.x + a.w * b.z - a.z * b.w,
            a.x * b.z + a.z * b.x + a.y * b.w - a.w * b.y, a.x * b.w + a.w * b.x + a.z * b.y - a.y * b.z};
  } else {
    return {a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w, a.x * b.y + a.y * b.x - a.z * b.w + a.w * b.z,
            a.x * b.z + a.y * b.w + a.z * b.x - a.w * b.y, a.x * b.w - a.y * b.z + a.z * b.y + a.w * b.x};
  }
}
/// The distance to the set, estimated. [Hart, Sandin, Kauffman 1989, "Ray tracing deterministic 3-D fractals"]
template <int kPower, class L>
FIRSTLIGHT_LANE_FUNCTION L distance(QuaternionPower<kPower> rule, const double* orbit, const L& last,
                                    const MaskOf<L>& who, const Vec3Of<L>&, double) {
  Vec4Of<L> value = value_at<L>(orbit, 0);
  Vec4Of<L> product = value;
  L share = 1.0 / kPower;
  for (std::size_t i = 1;; ++i) {
    const auto before = who & (static_cast<double>(i) <= last);
    if (!any(before)) break;
    const Vec4Of<L> next = value_at<L>(orbit, i);
    product = select(before, quaternion_product(rule, product, next), product);
    share = select(before, share / static_cast<double>(kPower), share);
    value = select(before, next, value);
  }
  const L square = square_of(rule, value);
  return share * sqrt(square / square_length(product)) * logarithm(square);
}
template <int kPower, class L>
HWY_INLINE Vec4Of<L> derivative(QuaternionPower<kPower>, const Vec4Of<L>& q, const Vec4Of<L>& n) {
  if constexpr (kPower == 2) {
    return {n.x * q.x - n.y * q.y - n.z * q.z - n.w * q.w, n.x * q.y + q.x * n.y, n.x * q.z + q.x * n.z,
            n.x * q.w + q.x * n.w};
  } else {
    const L d = q.y * q.y + q.z * q.z + q.w * q.w;
    const L mixed = 2.0 * (n.y * q.y + n.z * q.z + n.w * q.w);
    const L f = 6.0 * q.x * n.x - mixed;
    const L g = 3.0 * q.x * q.x - d;
    return {(n.x * (q.x * q.x - d) - q.x * mixed) * 3.0, n.y * g + q.y * f, n.z * g + q.z * f, n.w * g + q.w * f};
  }
}
/// The derivatives of the value by x, y and z of the first, each times that value.
template <class L, int kPower>
FIRSTLIGHT_LANE_FUNCTION Vec3Of<L> growth(QuaternionPower<kPower> rule, const double* orbit, std::size_t last) {
  const L zero = 0.0, one = 1.0;
  Vec4Of<L> by[3] = {{one, zero, zero, zero}, {zero, one, zero, zero}, {zero, zero, one, zero}};
  for (std::size_t i = 0; i < last; ++i) {
    const auto q = value_at<L>(orbit, i);
    for (Vec4Of<L>& d : by) d = derivative(rule, q, d);
  }
  const auto q = value_at<L>(orbit, last);
  L along[3];
  for (std::size_t k = 0; k < 3; ++k) along[k] = by[k].x * q.x + by[k].y * q.y + by[k].z * q.z + by[k].w * q.w;
  return {along[0], along[1], along[2]};
}

// Functions of hypercomplex numbers. Each has also `grown`, what becomes of a change at a value; kGrows: and by 2.

struct HyperSquare {
  static constexpr bool kGrows = true;
};
template <class L>
HWY_INLINE L square_of(HyperSquare, const Vec4Of<L>& q) {
  return (q.x * q.x + q.w * q.w) + (q.y * q.y + q.z * q.z);
}
template <class L>
HWY_INLINE Vec4Of<L> next_value(HyperSquare, const Vec4Of<L>& q, const Vec4Of<L>&) {
  Vec4Of<L> square = hyper_square(q);
  square.x = (q.x * q.x + q.w * q.w) - (q.y * q.y + q.z * q.z);
  return square;
}
template <class L>
HWY_INLINE Vec4Of<L> grown(HyperSquare, const Vec4Of<L>& change, const Vec4Of<L>& q) {
  return hyper_product(q, change);
}
/// POV-Ray iterates the square here too.
struct HyperCube {
  static constexpr bool kGrows = false;
};
template <class L>
HWY_INLINE L square_of(HyperCube, const Vec4Of<L>& q) {
  return square_length(q);
}
template <class L>
HWY_INLINE Vec4Of<L> next_value(HyperCube, const Vec4Of<L>& q, const Vec4Of<L>&) {
  return hyper_square(q);
}
template <class L>
HWY_INLINE Vec4Of<L> grown(HyperCube, const Vec4Of<L>& change, const Vec4Of<L>& q) {
  return hyper_product(q, change);
}
/// Where there is none, the one before it.
struct HyperReciprocal {
  static constexpr bool kGrows = false;
};
template <class L>
HWY_INLINE L square_of(HyperReciprocal, const Vec4Of<L>& q) {
  return square_length(q);
}
template <class L>
HWY_INLINE Vec4Of<L> next_value(HyperReciprocal, const Vec4Of<L>& q, const Vec4Of<L>& before) {
  return hyper_reciprocal(q, before);
}
template <class L>
HWY_INLINE Vec4Of<L> grown(HyperReciprocal, const Vec4Of<L>& change, const Vec4Of<L>& q) {
  const L zero = 0.0;
  const auto square = hyper_square(hyper_reciprocal(q, Vec4Of<L>{zero, zero, zero, zero}));
  return hyper_product(change, Vec4Of<L>{-square.x, -square.y, -square.z, -square.w});
}
struct HyperFunction {
  static constexpr bool kGrows = false;
  JuliaFunction function;
  std::complex<double> exponent;
};
template <class L>
HWY_INLINE L square_of(const HyperFunction&, const Vec4Of<L>& q) {
  return square_length(q);
}
template <class L>
HWY_INLINE Vec4Of<L> next_value(const HyperFunction& rule, const Vec4Of<L>& q, const Vec4Of<L>&) {
  return hyper_function(rule.function, rule.exponent, q);
}
template <class L>
HWY_INLINE Vec4Of<L> grown(const HyperFunction& rule, const Vec4Of<L>& change, const Vec4Of<L>& q) {
  return hyper_product(hyper_function(rule.function, rule.exponent, q), change);
}

template <class L, class Rule>
FIRSTLIGHT_LANE_FUNCTION Vec3Of<L> growth_until(const Rule& rule, const double* orbit, const L& last,
                                                const MaskOf<L>& who) {
  Vec4Of<L> value = value_at<L>(orbit, 0);
  Vec4Of<L> q = value;
  L factor = Rule::kGrows ? 2.0 : 1.0;
  for (std::size_t i = 1;; ++i) {
    const auto there = who & (static_cast<double>(i) <= last);
    if (!any(there)) break;
    value = select(there, value_at<L>(orbit, i), value);
    const auto before = there & (static_cast<double>(i) < last);
    if (!any(before)) continue;
    q = select(before, grown(rule, q, value), q);
    if (Rule::kGrows) factor = select(before, factor * 2.0, factor);
  }
  const Vec4Of<L> n = value * factor;
  return {q.x * n.x + q.y * n.y + q.z * n.z + q.w * n.w, -q.y * n.x + q.x * n.y - q.w * n.z + q.z * n.w,
          -q.z * n.x - q.w * n.y + q.x * n.z + q.y * n.w};
}
template <class L, class Rule>
FIRSTLIGHT_LANE_FUNCTION Vec3Of<L> growth(const Rule& rule, const double* orbit, std::size_t last) {
  return growth_until(rule, orbit, L(static_cast<double>(last)), L::first(L::kCount));
}
/// By how far the size grows along the ray; the least step where that says nothing.
template <class L, class Rule>
FIRSTLIGHT_LANE_FUNCTION L distance(const Rule& rule, const double* orbit, const L& last, const MaskOf<L>& who,
                                    const Vec3Of<L>& direction, double least) {
  const L fall = -dot(growth_until(rule, orbit, last, who), direction);
  Vec4Of<L> value = value_at<L>(orbit, 0);
  for (std::size_t i = 1;; ++i) {
    const auto there = who & (static_cast<double>(i) <= last);
    if (!any(there)) break;
    value = select(there, value_at<L>(orbit, i), value);
  }
  const L slope = 2.0 * fall;
  const L square = square_of(rule, value);
  const auto says = (fall > kLeastSlope) & (square > least * slope) & (square < kLongestStep * least * slope);
  return select(says, square / slope, L(least));
}

/// visit(rule) for the set's rule.
template <class Visit>
HWY_INLINE auto with_rule(const JuliaFractalParameters& p, const Visit& visit) {
  if (p.algebra == JuliaFractalParameters::Algebra::quaternion) {
    if (p.function == JuliaFunction::cube) return visit(QuaternionPower<3>());
    return visit(QuaternionPower<2>());
  }
  if (p.function == JuliaFunction::square) return visit(HyperSquare());
  if (p.function == JuliaFunction::cube) return visit(HyperCube());
  if (p.function == JuliaFunction::reciprocal) return visit(HyperReciprocal());
  return visit(HyperFunction{p.function, p.exponent});
}

/// Rays on their ways.
template <class L, class Rule>
struct March {
  const JuliaFractal& set;
  const Rule& rule;
  Vec3Of<L> direction;
  double* orbit;
  L step;  ///< on from the point that was looked at last
  int iterations;
};
template <class L, class Rule>
HWY_INLINE March<L, Rule> march_of(const JuliaFractal& set, const Rule& rule, const Vec3Of<L>& direction) {
  const auto values = static_cast<std::size_t>(set.p.most_iterations) + 1;
  return {set, rule, direction, orbit_of_thread(4 * L::kCount * values), L(0.0), 0};
}
template <class L, class Rule>
HWY_INLINE bool must_leave(March<L, Rule>& march) {
  if (march.iterations < kIterationsBetween) return false;
  march.iterations = 0;
  return Interrupt::asked();
}

/// Which points are in the set; `last` gets the number of the last value of each orbit.
template <class L, class Rule>
FIRSTLIGHT_LANE_FUNCTION MaskOf<L> iterate(March<L, Rule>& march, const Vec3Of<L>& point, const MaskOf<L>& who,
                                           L& last) {
  const JuliaFractalParameters& p = march.set.p;
  const auto count = static_cast<std::size_t>(p.most_iterations);
  const Vec4& s = p.slice_normal;
  Vec4Of<L> q{point.x, point.y, point.z, (p.slice_distance - s.x * point.x - s.y * point.y - s.z * point.z) / s.w};
  Vec4Of<L> function{0.0, 0.0, 0.0, 0.0};
  keep_value(q, who, march.orbit, 0);
  last = static_cast<double>(count);
  auto within = who;
  for (std::size_t i = 0; i < count; ++i) {
    const auto out = within & (square_of(march.rule, q) > march.set.exit_value);
    last = select(out, L(static_cast<double>(i)), last);
    within = without(within, out);
    ++march.iterations;
    if (!any(within)) break;
    function = next_value(march.rule, q, function);
    q = {function.x + p.parameter.x, function.y + p.parameter.y, function.z + p.parameter.z,
         function.w + p.parameter.w};
    keep_value(q, within, march.orbit, i + 1);
  }
  return within;
}

/// The same, and how far the rays may step from there.
template <class L, class Rule>
FIRSTLIGHT_LANE_FUNCTION MaskOf<L> look(March<L, Rule>& march, const Vec3Of<L>& point, const MaskOf<L>& who) {
  L last;
  const auto is_in = iterate(march, point, who, last);
  const double least = 1.0 / march.set.p.precision;
  const auto outside = without(who, is_in);
  march.step = select(is_in, L(least), march.step);
  if (any(outside)) {
    march.step = select(outside, distance(march.rule, march.orbit, last, outside, march.direction, least), march.step);
  }
  return is_in;
}

template <class L, class Rule>
HWY_INLINE MaskOf<L> holding(March<L, Rule>& march, const Vec3Of<L>& point, const MaskOf<L>& who) {
  L last;
  return iterate(march, march.set.mistakes_z() ? Vec3Of<L>{point.x, point.y, point.y} : point, who, last);
}

template <class M>
HWY_INLINE M differing(const M& a, const M& b) {
  return without(a, b) | without(b, a);
}

/// How far behind `from` the surface is, from a step that changed sides; on the inner side of it, where the orbit then
/// begins.
template <class L, class Rule>
FIRSTLIGHT_LANE_FUNCTION L halved(March<L, Rule>& march, Vec3Of<L> from, L whole, const MaskOf<L>& was_in,
                                  const MaskOf<L>& who) {
  L gone = 0.0;
  for (;;) {
    const auto open = who & (whole > kTolerance);
    if (!any(open)) break;
    whole = select(open, whole * 0.5, whole);
    const Vec3Of<L> middle = from + march.direction * whole;
    const auto same = without(open, differing(holding(march, middle, open), was_in));
    from = select(same, middle, from);
    gone = select(same, gone + whole, gone);
  }
  from = select(was_in, from, from + march.direction * whole);
  gone = select(was_in, gone, gone + whole);
  holding(march, from, who);
  return gone;
}

/// The unit normals. Values that an orbit leaving the set does not reach are those of the orbit before it, as in
/// POV-Ray.
template <class L, class Rule>
FIRSTLIGHT_LANE_FUNCTION Vec3Of<L> normal_of(const March<L, Rule>& march) {
  const auto n = growth<L>(march.rule, march.orbit, static_cast<std::size_t>(march.set.p.most_iterations));
  const L largest = max(max(abs(n.x), abs(n.y)), abs(n.z));
  const auto is_one = (largest > 0.0) & (largest <= std::numeric_limits<double>::max());
  const Vec3Of<L> part = n / largest;
  return select(is_one, part / length(part), Vec3Of<L>{1.0, 0.0, 0.0});
}

/// Calls add(lane, depth, face, place) for the crossings of the rays in `who`; only for the first of each unless all
/// are wanted, even if it is too near to count.
///
/// Source   POV-Ray 3.7: a ray steps by what is known of the distance, at least by 1 / precision; where a step changes
///          sides, it is halved.
template <class L, class Rule, class Add>
HWY_INLINE void meet(const JuliaFractal& set, const Rule& rule, const RayOf<L>& given, const MaskOf<L>& who,
                     bool wants_all, const Add& add) {
  const UnitRayOf<L> unit = unit_ray(given);
  const RayOf<L>& ray = unit.ray;
  const auto through = through_sphere(ray, Vec3(0.0), set.radius * set.radius);
  const L last_depth = through.leaves;
  auto going = who & without(through.met, last_depth < kTolerance);
  if (!any(going)) return;
  L depth = max(through.enters, L(kTolerance));
  auto march = march_of(set, rule, ray.direction);
  Vec3Of<L> next = ray.origin + ray.direction * depth;
  auto is_in = look(march, next, going);
  if (any(is_in)) {  // perhaps of its own surface
    next = select(is_in, next + ray.direction * (2.0 * kTolerance), next);
    depth = select(is_in, depth + 2.0 * kTolerance, depth);
    going = without(going, is_in & (depth > last_depth));
    is_in = look(march, next, is_in & going);
  }
  const double least = 1.0 / set.p.precision;
  L steps = 0.0, whole = 0.0;
  Vec3Of<L> before = next;
  for (;;) {
    // Until each ray has changed sides or come to its end.
    auto changed = L::first(0);
    for (;;) {
      const L step = max(march.step, L(least));
      const auto stepping =
          without(going, changed) & (depth < last_depth) & (steps < kMostSteps) & (depth + step <= last_depth);
      going = going & (stepping | changed);
      if (!any(stepping)) break;
      if (must_leave(march)) return;
      before = select(stepping, next, before);
      whole = select(stepping, step, whole);
      next = select(stepping, next + ray.direction * step, next);
      steps = select(stepping, steps + 1.0, steps);
      const auto now_in = look(march, next, stepping);
      const auto turned = stepping & differing(now_in, is_in);
      is_in = without(is_in, stepping) | now_in;
      depth = select(without(stepping, turned), depth + step, depth);
      changed = changed | turned;
    }
    if (!any(changed)) return;
    const L found = depth + halved(march, before, whole, !is_in, changed);
    const Vec3Of<L> n = normal_of(march);
    double at[L::kCount], x[L::kCount], y[L::kCount], z[L::kCount];
    (found * (1.0 / unit.length)).store(at);
    n.x.store(x);
    n.y.store(y);
    n.z.store(z);
    for (unsigned left = bits(changed); left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctz(left));
      add(i, at[i], z[i] < 0.0 ? 1u : 0u, {x[i], y[i]});
    }
    if (!wants_all) return;
    depth = select(changed, depth + whole, depth);
  }
}

void meet_julia(const JuliaFractal& set, const RaysAndPlace& asked, Slots& slots) {
  SlotLists lists(asked.shape, slots, true);
  with_rule(set.p, [&](const auto& rule) HWY_ATTR {
    for_each_vector(asked, [&](const RayOf<Lanes>& ray, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
      meet(set, rule, ray, Lanes::mask_of(static_cast<unsigned>(of_vector)), asked.nearest_only == nullptr,
           [&](std::size_t lane, double depth, std::uint32_t face, const std::array<double, 2>& place) {
             lists.add(i + lane, depth, face, place);
           });
    });
  });
}
void meet_julia_with_one(const JuliaFractal& set, const Ray& ray, Met& met) {
  const RayOf<One> one{everywhere<One>(ray.origin), everywhere<One>(ray.direction)};
  with_rule(set.p, [&](const auto& rule) HWY_ATTR {
    meet(set, rule, one, One::first(1), met.wants_all(),
         [&](std::size_t, double depth, std::uint32_t face, const std::array<double, 2>& place) {
           met.add(depth, face, place);
         });
  });
}

template <class L>
HWY_INLINE MaskOf<L> inside(const JuliaFractal& set, const Vec3Of<L>& point, bool inverted) {
  return with_rule(set.p, [&](const auto& rule) HWY_ATTR {
    auto march = march_of(set, rule, Vec3Of<L>{0.0, 0.0, 0.0});
    const auto holds = holding(march, point, L::first(L::kCount));
    return inverted ? !holds : holds;
  });
}
FIRSTLIGHT_INSIDE_KERNEL(JuliaFractal)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

FIRSTLIGHT_INSIDE_MEMBERS(JuliaFractal)
HWY_EXPORT(meet_julia);

void JuliaFractal::meet_block(const RaysAndPlace& asked, Slots& slots) const {
  HWY_DYNAMIC_DISPATCH(meet_julia)(*this, asked, slots);
}
void JuliaFractal::meet(const Ray& ray, Met& met) const { HWY_NAMESPACE::meet_julia_with_one(*this, ray, met); }

}  // namespace

ShapePtr make_julia_fractal(const JuliaFractalParameters& parameters) {
  JuliaFractal set{parameters, 4.0, 16.0};
  if (parameters.algebra == JuliaFractalParameters::Algebra::quaternion) {
    set.radius = std::min(2.0, 1.0 + parameters.parameter.length() + kTolerance);
    set.exit_value = set.radius * set.radius + kTolerance;
  }
  return std::make_shared<Placed<JuliaFractal>>(set, Transform());
}

}  // namespace firstlight::render
#endif
