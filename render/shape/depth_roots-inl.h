// How rays of a block meet surfaces whose equation along a ray is a polynomial in the depth. Included once for each
// instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_SHAPE_DEPTH_ROOTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_SHAPE_DEPTH_ROOTS_INL_H
#undef FIRSTLIGHT_RENDER_SHAPE_DEPTH_ROOTS_INL_H
#else
#define FIRSTLIGHT_RENDER_SHAPE_DEPTH_ROOTS_INL_H
#endif

#include "render/math/polynomial-inl.h"
#include "render/shape/lane_shape-inl.h"
#include "render/shape/root_jobs.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// A ray from the point on that is nearest to the origin: there the coefficients of equations keep their digits, however
/// far away it starts. Depths of the ray as it was given are (t + skipped) / length.
template <class L>
struct NearRay {
  Vec3Of<L> p, d;
  L skipped, length;
};

template <class L>
HWY_INLINE NearRay<L> near_ray(const UnitRayOf<L>& unit) {
  const auto& [origin, direction] = unit.ray;
  const L skipped = -dot(origin, direction);
  return {origin + direction * skipped, direction, skipped, unit.length};
}

/// A surface's equation along a ray: a polynomial of order kOrder that is 0 where they meet, between `low` and `high`.
/// Depths in it are counted from `skipped` on and along a direction of unit length: the depth `t` in it is
/// (t + skipped) / length of the ray as it was given.
template <class L, std::size_t kOrder>
struct DepthEquation {
  L c[kOrder + 1];
  L low, high;
  L skipped;
  L length;
};

/// Adds the equations of those rays from the i-th on whose bits are in `of_vector`.
template <class Jobs>
HWY_INLINE void add_jobs(Jobs& jobs, std::size_t i, std::uint64_t of_vector, std::uint32_t part, std::size_t order,
                         const Lanes* c, const Lanes& low, const Lanes& high) {
  double numbers[RootBatch::kMostRoots + 1][Lanes::kCount];
  double lows[Lanes::kCount];
  double highs[Lanes::kCount];
  for (std::size_t k = 0; k <= order; ++k) c[k].store(numbers[k]);
  low.store(lows);
  high.store(highs);
  for (std::uint64_t left = of_vector & bits(low < high); left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctzll(left));
    jobs.add(i + lane, part, order, &numbers[0][lane], Lanes::kCount, lows[lane], highs[lane]);
  }
}

/// Equations of the rays of a block.
struct DepthEquations {
  PolynomialColumns polynomials;
  Column<double> skipped, length;
  std::uint64_t rays;  ///< bits of those that have one

  void begin(std::size_t order) {
    polynomials.order = order;
    rays = 0;
  }
  template <std::size_t kOrder>
  HWY_INLINE void set(std::size_t i, std::uint64_t of_vector, const DepthEquation<Lanes, kOrder>& equation) {
    for (std::size_t k = 0; k <= polynomials.order; ++k) store(equation.c[k], polynomials.c[k], i);
    store(equation.low, polynomials.low, i);
    store(equation.high, polynomials.high, i);
    store(equation.skipped, skipped, i);
    store(equation.length, length, i);
    rays |= (of_vector & bits(equation.low < equation.high)) << i;
  }
};

/// Appends the rays' crossings. crossing(t + skipped, length, counts) gives a depth along the given ray, and tells whether
/// it counts.
template <class Crossing>
HWY_INLINE void meet_at_roots(const DepthEquations& equations, const RaysAndPlace& asked, Slots& slots,
                              const Crossing& crossing) {
  RootColumns roots(equations.polynomials, equations.rays);
  SlotLists lists(asked.shape, slots, false);
  std::uint64_t open = equations.rays;
  Column<double> root;
  for (;;) {
    open = roots.next(open, root);
    if (open == 0) return;
    std::uint64_t met = 0;
    for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
      const std::uint64_t of_vector = open >> i & kAllLanes;
      if (of_vector == 0) continue;
      LanesMask counts;
      const auto depth =
          crossing(load<Lanes>(root, i) + load<Lanes>(equations.skipped, i), load<Lanes>(equations.length, i), counts);
      store(depth, root, i);
      const std::uint64_t here = bits(counts) & of_vector;
      met |= here << i;
      if (asked.nearest_only != nullptr) {
        open &= ~((bits(depth > load<Lanes>(asked.nearest_only->low, i)) & here) << i);
      }
    }
    for (; met != 0; met &= met - 1) {
      const auto ray = static_cast<std::size_t>(__builtin_ctzll(met));
      lists.add(ray, root[ray]);
    }
  }
}

/// The same of one ray.
template <std::size_t kOrder, class Crossing>
HWY_INLINE void meet_at_roots(const DepthEquation<One, kOrder>& equation, std::size_t order, Met& met,
                              const Crossing& crossing) {
  double c[kOrder + 1];
  for (std::size_t k = 0; k <= order; ++k) c[k] = equation.c[k].v;
  PolynomialRoots roots({c, order + 1}, equation.low.v, equation.high.v);
  for (double t; !met.is_enough() && roots.next(t);) {
    OneMask counts;
    const One depth = crossing(t + equation.skipped, equation.length, counts);
    if (counts.holds) met.add(depth.v);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
