#include "render/shape/superellipsoid.h"

#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/superellipsoid.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/math-inl.h"
#include "render/shape/lane_shape-inl.h"

#include <algorithm>
#include <array>
#include <utility>

#ifndef FIRSTLIGHT_RENDER_SHAPE_SUPERELLIPSOID
#define FIRSTLIGHT_RENDER_SHAPE_SUPERELLIPSOID
namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-4;  ///< POV-Ray's for this shape, as all that follows
constexpr double kZero = 1e-10;
constexpr double kReach = 1.01;
constexpr double kStepBehind = 1e-4;  ///< relative, the first of Newton's steps
constexpr int kMostSteps = 20;
constexpr int kMostGuesses = 40;  ///< ours; rays from very far away see no value below kZero

/// Planes on which two coordinates are equal in size, or one is 0: between them the surface is smooth.
constexpr std::size_t kPlanes = 9;
constexpr std::size_t kMostStops = kPlanes + 2;

/// ((|x|^around + |y|^around)^(along / around) + |z|^along)^(1 / along) - 1: less than 0 inside.
/// Source   POV-Ray 3.7's reference manual, "Superquadric Ellipsoid".
struct Superellipsoid {
  double around;  ///< 2 / e
  double along;   ///< 2 / n

  void meet(const Ray& ray, Met& met) const;
  bool inside(const Vec3& point, bool inverted) const;
  void meet_block(const RaysAndPlace& asked, Slots& slots) const;
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const;
  Vec3 normal(const Vec3& point, const Crossing&) const;
  void normals(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns3<double>& out) const;
  /// Whether the value is a convex function of the point: a norm, less 1.
  bool is_convex() const { return around >= 1.0 && along >= 1.0; }
  Box3 bounds() const { return Box3(Vec3(-1.0001), Vec3(1.0001)); }
  Box3 inside_bounds() const { return bounds(); }
};

/// Depths between which rays have a crossing, and the values there, of different signs. Where that of `a` is 0 the
/// crossing is at `a`.
struct Brackets {
  Column<double> a, at_a, b, at_b;
};

/// Rays that look for their crossings from stop to stop: where they come into the box about the shape, cross the
/// planes and leave. Bits are those of the rays.
struct Search {
  RayColumns rays;  ///< in the shape's space, with directions of unit length
  Column<double> length;
  std::array<Column<double>, kMostStops> stops;  ///< in order; an infinite one is behind the last
  std::uint64_t open = 0;                        ///< the rays that have not looked at all of their stops
  Column<double> next;                           ///< the number of the stop to be looked at
  Column<double> before;                         ///< the value at the stop before it
  Column<double> earlier;                        ///< and at the one before that; infinite where there is none
  std::uint64_t found;                           ///< rays that know where their next crossing is
  std::uint64_t must_count;                      ///< rays that end if that crossing does not count
  Brackets brackets;
  Column<double> root;  ///< the crossing
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// The logarithm of (a^e + b^e)^(1/e) from those of a and b, with an error of some 1e-16: much less than what counts as
/// zero here.
template <class L>
HWY_INLINE L log_norm(const L& a, const L& b, double e) {
  const L larger = max(a, b);
  const L ratio = select(larger == -kInfinite, L(0.0), min(a, b) - larger);
  return larger + logarithm(1.0 + exponential(ratio * e)) * (1.0 / e);
}

template <class L>
HWY_NOINLINE L value_at(const Superellipsoid& form, const Vec3Of<L>& p) {
  const L x = logarithm(abs(p.x)), y = logarithm(abs(p.y)), z = logarithm(abs(p.z));
  return exponential(log_norm(log_norm(x, y, form.around), z, form.along)) - 1.0;
}
template <class L>
HWY_INLINE L value_along(const Superellipsoid& form, const RayOf<L>& ray, const L& depth) {
  return value_at(form, ray.origin + ray.direction * depth);
}

/// Into ascending order. [K. E. Batcher, Sorting networks and their applications, 1968: merge exchange]
template <class L, std::size_t kCount>
HWY_INLINE void sort(L (&numbers)[kCount]) {
  for (std::size_t p = 1; p < kCount; p *= 2) {
    for (std::size_t k = p; k > 0; k /= 2) {
      for (std::size_t i = k % p; i + k < kCount; i += 2 * k) {
        for (std::size_t j = i; j < i + k && j + k < kCount; ++j) {
          if (j / (2 * p) != (j + k) / (2 * p)) continue;
          const L larger = max(numbers[j + k], numbers[j]);
          numbers[j] = min(numbers[j], numbers[j + k]);
          numbers[j + k] = larger;
        }
      }
    }
  }
}

/// Returns which of the rays, with directions of unit length, have stops.
template <class L>
HWY_INLINE MaskOf<L> find_stops(const RayOf<L>& ray, L (&stops)[kMostStops]) {
  const auto& [o, d] = ray;
  L near = -kBoundingHuge;
  L far = kBoundingHuge;
  auto beside = near > far;
  for (const auto& [from, by] : {std::pair<const L&, const L&>(o.x, d.x), {o.y, d.y}, {o.z, d.z}}) {
    const auto moves = abs(by) > kEpsilon;
    const L reach = copysign(L(kReach), by);
    near = select(moves, max(near, (-reach - from) / by), near);
    far = select(moves, min(far, (reach - from) / by), far);
    beside = beside | without(abs(from) > kReach, moves);
  }
  const auto misses = beside | (near > far) | (far < kNearest);
  near = max(near, L(kNearest));
  const L room = kEpsilon * (far - near);
  const L low = near - room;
  const L high = far + room;
  const L heights[kPlanes] = {o.x + o.y, o.x - o.y, o.x + o.z, o.x - o.z, o.y + o.z, o.y - o.z, o.x, o.y, o.z};
  const L slopes[kPlanes] = {d.x + d.y, d.x - d.y, d.x + d.z, d.x - d.z, d.y + d.z, d.y - d.z, d.x, d.y, d.z};
  stops[0] = near;
  stops[1] = far;
  for (std::size_t i = 0; i < kPlanes; ++i) {
    const L at = -heights[i] / slopes[i];
    const auto counts = without((at >= low) & (at <= high), abs(slopes[i]) < kEpsilon);
    stops[i + 2] = select(counts, at, L(kInfinite));
  }
  sort(stops);
  return !misses;
}

/// Begins the search of the rays in `who`, of which the first stands at `i`.
template <class L>
HWY_INLINE void begin(const RayOf<L>& given, std::size_t i, std::uint64_t who, Search& search) {
  const UnitRayOf<L> unit = unit_ray(given);
  L stops[kMostStops];
  who &= bits(find_stops(unit.ray, stops));
  if (who == 0) return;
  search.open |= who << i;
  store3(unit.ray.origin, search.rays.origin, i);
  store3(unit.ray.direction, search.rays.direction, i);
  store(unit.length, search.length, i);
  for (std::size_t k = 0; k < kMostStops; ++k) store(stops[k], search.stops[k], i);
  store(L(0.0), search.next, i);
  store(L(kInfinite), search.before, i);
  store(L(kInfinite), search.earlier, i);
}

/// As Brackets.
template <class L>
struct Bracket {
  L a, at_a, b, at_b;
};
template <class L>
HWY_INLINE void set(Bracket<L>& bracket, const MaskOf<L>& which, const Bracket<L>& other) {
  bracket.a = select(which, other.a, bracket.a);
  bracket.at_a = select(which, other.at_a, bracket.at_a);
  bracket.b = select(which, other.b, bracket.b);
  bracket.at_b = select(which, other.at_b, bracket.at_b);
}
template <class L>
HWY_INLINE Bracket<L> crossing_at(const L& depth) {
  return {depth, 0.0, depth, 1.0};
}

/// Between two depths at which the values have one sign there may be two roots: Newton's steps from the first of the
/// depths. Returns the rays that come to where the sign changes, or to a root.
template <class L>
HWY_INLINE MaskOf<L> find_first_of_two(const Superellipsoid& form, const RayOf<L>& ray, MaskOf<L> going, L a, L at_a,
                                       const L& b, Bracket<L>& bracket) {
  const L longest = b - a;
  L next = a + kStepBehind * longest;
  auto found = without(going, going);
  for (int step = 0; step < kMostSteps; ++step) {
    going = going & (a < b);
    if (!any(going)) break;
    const L value = value_along(form, ray, next);
    const auto changes = going & (at_a * value < 0.0);
    const auto is_root = without(going & (abs(value) < kZero), changes);
    set(bracket, changes, {a, at_a, next, value});
    set(bracket, is_root, crossing_at(next));
    found = found | changes | is_root;
    const L farther = value * ((next - a) / (at_a - value));
    going = without(going & (abs(value) < abs(at_a)) & (abs(farther) <= longest), changes | is_root);
    at_a = value;
    a = next;
    next = next + farther;
  }
  return found;
}

/// The least that values have risen between two stops, whatever their rounding. Those of a convex shape rise at least
/// as steeply from there on: a ray outside for which this is positive has left the shape for good.
template <class L>
HWY_INLINE L least_rise(const L& earlier, const L& before, const L& stop) {
  return before - earlier - kZero * (1.0 + stop);
}

/// Goes with the open rays from the i-th on from stop to stop, each until it knows where a crossing is or has looked
/// at all.
template <class L>
HWY_INLINE void look_on(const Superellipsoid& form, std::size_t i, Search& search) {
  constexpr std::uint64_t kAll = (std::uint64_t{1} << L::kCount) - 1;
  const RayOf<L> ray{load3<L>(search.rays.origin, i), load3<L>(search.rays.direction, i)};
  auto going = L::mask_of(static_cast<unsigned>(search.open >> i & kAll));
  L next = load<L>(search.next, i);
  L before = load<L>(search.before, i);
  L earlier = load<L>(search.earlier, i);
  Bracket<L> bracket = crossing_at(L(0.0));
  auto found = without(going, going);
  auto must_count = found;
  const bool is_convex = form.is_convex();
  L last = 0.0;
  L width = 0.0;  // between the two stops before
  for (std::size_t k = 0; k < kMostStops; ++k) {
    const L stop = load<L>(search.stops[k], i);
    going = going & (stop < kInfinite);
    if (!any(going)) break;
    auto here = going & (next <= static_cast<double>(k));
    const L rise = least_rise(earlier, before, last);
    if (is_convex) {
      const auto leaves = here & (before > 0.0) & (rise > 0.0);
      here = without(here, leaves);
      going = without(going, leaves);
    }
    if (any(here)) {
      const L value = value_along(form, ray, stop);
      const auto is_root = here & (abs(value) < kZero);
      set(bracket, is_root, crossing_at(stop));
      auto ends = is_root;
      if (k > 0) {
        const auto changes = without(here & (before * value < 0.0), is_root);
        set(bracket, changes, {last, before, stop, value});
        ends = ends | changes;
        auto same = without(here, ends);
        if (is_convex) same = without(same, (before < 0.0) | (before * width + rise * (stop - last) > 0.0));
        if (any(same)) {
          const auto first_of_two = find_first_of_two(form, ray, same, last, before, stop, bracket);
          must_count = must_count | first_of_two;
          ends = ends | first_of_two;
        }
      }
      earlier = select(here, before, earlier);
      before = select(here, value, before);
      next = select(here, L(static_cast<double>(k + 1)), next);
      found = found | ends;
      going = without(going, ends);
    }
    width = stop - last;
    last = stop;
  }
  const std::uint64_t found_bits = bits(found);
  search.open &= ~(kAll << i) | found_bits << i;
  if (found_bits == 0) return;
  search.found |= found_bits << i;
  search.must_count |= static_cast<std::uint64_t>(bits(must_count)) << i;
  store(next, search.next, i);
  store(before, search.before, i);
  store(earlier, search.earlier, i);
  store(bracket.a, search.brackets.a, i);
  store(bracket.at_a, search.brackets.at_a, i);
  store(bracket.b, search.brackets.b, i);
  store(bracket.at_b, search.brackets.at_b, i);
}

/// Where the secant between the ends is 0.
template <class L>
HWY_INLINE L secant(const Bracket<L>& bracket) {
  return bracket.a + (bracket.b - bracket.a) * (abs(bracket.at_a) / abs(bracket.at_b - bracket.at_a));
}

/// Secants, of which an end that stays counts for less and less.
/// Source   M. Dowell & P. Jarratt, "The 'Pegasus' method for computing the root of an equation", 1972.
template <class L>
HWY_INLINE L root_within(const Superellipsoid& form, const RayOf<L>& ray, MaskOf<L> open, Bracket<L> bracket) {
  auto& [a, at_a, b, at_b] = bracket;
  open = without(open, (abs(at_a) < kZero) | (abs(at_b) < kZero));
  L root = secant(bracket);
  for (int guess = 0; guess < kMostGuesses && any(open); ++guess) {
    const L value = value_along(form, ray, root);
    const auto changes = value * at_b < 0.0;
    a = select(changes, b, a);
    at_a = select(changes, at_b, at_a * (at_b / (at_b + value)));
    b = root;
    at_b = value;
    root = select(open, secant(bracket), root);
    open = without(open, abs(value) < kZero);
  }
  return root;
}

/// Finds the crossings of those that know where theirs is, side by side.
template <class L>
HWY_INLINE void find_roots(const Superellipsoid& form, Search& search) {
  RayColumns rays;
  Brackets brackets;
  Column<double> root;
  std::size_t count = 0;
  for (std::uint64_t left = search.found; left != 0; left &= left - 1, ++count) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rays.origin.of[axis][count] = search.rays.origin.of[axis][i];
      rays.direction.of[axis][count] = search.rays.direction.of[axis][i];
    }
    brackets.a[count] = search.brackets.a[i];
    brackets.at_a[count] = search.brackets.at_a[i];
    brackets.b[count] = search.brackets.b[i];
    brackets.at_b[count] = search.brackets.at_b[i];
  }
  for (std::size_t i = 0; i < count; i += L::kCount) {
    const RayOf<L> ray{load3<L>(rays.origin, i), load3<L>(rays.direction, i)};
    const Bracket<L> bracket{load<L>(brackets.a, i), load<L>(brackets.at_a, i), load<L>(brackets.b, i),
                             load<L>(brackets.at_b, i)};
    store(root_within(form, ray, L::first(count - i), bracket), root, i);
  }
  count = 0;
  for (std::uint64_t left = search.found; left != 0; left &= left - 1) {
    search.root[static_cast<std::size_t>(__builtin_ctzll(left))] = root[count++];
  }
}

/// add(i, depth) for the crossings of the rays that are open, and returns whether the i-th ray looks for more.
template <class L, class Add>
HWY_INLINE void meet(const Superellipsoid& form, Search& search, const Add& add) {
  while (search.open != 0) {
    search.found = search.must_count = 0;
    constexpr std::uint64_t kAll = (std::uint64_t{1} << L::kCount) - 1;
    for (std::size_t i = 0; i < kRaysAtOnce && search.open >> i != 0; i += L::kCount) {
      if ((search.open >> i & kAll) != 0) look_on<L>(form, i, search);
    }
    find_roots<L>(form, search);
    for (std::uint64_t left = search.found; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
      const std::uint64_t bit = left & -left;
      const double depth = search.root[i] / search.length[i];
      const bool goes_on = depth > kNearest && depth < kMaxDistance ? add(i, depth) : (search.must_count & bit) == 0;
      if (!goes_on) search.open &= ~bit;
    }
  }
}

void meet_superellipsoid(const Superellipsoid& form, const RaysAndPlace& asked, Slots& slots) {
  Search search;
  for_each_vector(asked, [&](const RayOf<Lanes>& ray, std::size_t i, std::uint64_t of_vector)
                             HWY_ATTR { begin(ray, i, of_vector, search); });
  SlotLists lists(asked.shape, slots, false);
  meet<Lanes>(form, search, [&](std::size_t i, double depth) {
    lists.add(i, depth);
    return asked.nearest_only == nullptr || !(depth > asked.nearest_only->low[i]);
  });
}

inline void meet_superellipsoid_once(const Superellipsoid& form, const Ray& ray, Met& met) {
  Search search;
  begin(RayOf<One>{everywhere<One>(ray.origin), everywhere<One>(ray.direction)}, 0, 1, search);
  meet<One>(form, search, [&](std::size_t, double depth) {
    met.add(depth);
    return !met.is_enough();
  });
}

template <class L>
HWY_INLINE MaskOf<L> inside(const Superellipsoid& form, const Vec3Of<L>& p, bool inverted) {
  const auto is_in = value_at(form, p) < kEpsilon;
  return inverted ? !is_in : is_in;
}

FIRSTLIGHT_INSIDE_KERNEL(Superellipsoid)

/// Outward, of any length. [POV-Ray 3.7]
template <class L>
HWY_INLINE Vec3Of<L> normal_at(const Superellipsoid& form, const Vec3Of<L>& p) {
  const auto has_x = p.x != 0.0;
  const auto has_y = p.y != 0.0;
  const auto has_z = p.z != 0.0;
  const L top = select(has_z, power(abs(p.z), L(form.along)), L(0.0));
  const auto is_wide = abs(p.x) > abs(p.y);
  const L quotient = select(is_wide, p.y / p.x, p.x / p.y);
  const L ratio = select(is_wide | has_y, power(abs(quotient), L(form.around)), L(0.0));
  const L x = (1.0 - top) * select(is_wide, L(1.0), ratio) / p.x;
  const L y = (1.0 - top) * select(is_wide, ratio, L(1.0)) / p.y;
  return {select(has_x, x, L(0.0)), select(has_y, y, L(0.0)), select(has_z, top / p.z, p.z) * (1.0 + ratio)};
}

void superellipsoid_normals(const Superellipsoid& form, const SurfacePlaces& places, std::size_t first, std::size_t end,
                            Columns3<double>& out) {
  Columns3<double> found;
  for (std::size_t i = first / Lanes::kCount * Lanes::kCount; i < end; i += Lanes::kCount) {
    store3(normal_at(form, load3<Lanes>(places.point, i)), found, i);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::copy(&found.of[axis][first], found.of[axis].at.data() + end, &out.of[axis][first]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(meet_superellipsoid);
HWY_EXPORT(superellipsoid_normals);
FIRSTLIGHT_INSIDE_MEMBERS(Superellipsoid)

void Superellipsoid::meet(const Ray& ray, Met& met) const { HWY_NAMESPACE::meet_superellipsoid_once(*this, ray, met); }

void Superellipsoid::meet_block(const RaysAndPlace& asked, Slots& slots) const {
  HWY_DYNAMIC_DISPATCH(meet_superellipsoid)(*this, asked, slots);
}

Vec3 Superellipsoid::normal(const Vec3& point, const Crossing&) const {
  const auto n = HWY_NAMESPACE::normal_at(*this, HWY_NAMESPACE::everywhere<One>(point));
  return Vec3(n.x.v, n.y.v, n.z.v);
}

void Superellipsoid::normals(const SurfacePlaces& places, std::size_t first, std::size_t end,
                             Columns3<double>& out) const {
  HWY_DYNAMIC_DISPATCH(superellipsoid_normals)(*this, places, first, end, out);
}

}  // namespace

ShapePtr make_superellipsoid(double east_west, double north_south) {
  return std::make_shared<Placed<Superellipsoid>>(Superellipsoid{2.0 / east_west, 2.0 / north_south}, Transform());
}

}  // namespace firstlight::render
#endif
