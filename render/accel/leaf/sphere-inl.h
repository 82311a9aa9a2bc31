// How a ray meets several spheres at once. Lane by lane the operations are those of meet_sphere in the same order, none
// fused: the depths are the same to the bit.
// Included once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_ACCEL_LEAF_SPHERE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_ACCEL_LEAF_SPHERE_INL_H
#undef FIRSTLIGHT_RENDER_ACCEL_LEAF_SPHERE_INL_H
#else
#define FIRSTLIGHT_RENDER_ACCEL_LEAF_SPHERE_INL_H
#endif

#include "render/accel/box_test-inl.h"
#include "render/accel/leaf/doubles-inl.h"
#include "render/accel/leaf/sphere.h"
#include "render/accel/ray_block.h"
#include "render/shape/tolerance.h"

#include <hwy/highway.h>

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Where rays pass through spheres, by the steps of meet_sphere().
struct SphereMeeting {
  using V = hn::VFromD<Doubles>;

  decltype(hn::Eq(V(), V())) met;
  V enters, leaves;

  /// `x`, `y` and `z` lead from the origin to the centre.
  HWY_INLINE SphereMeeting(const V& x, const V& y, const V& z, const V& radius_squared, const V& direction_x,
                           const V& direction_y, const V& direction_z) {
    const auto epsilon = hn::Set(Doubles(), kEpsilon);
    const auto distance_squared = dot(x, y, z, x, y, z);
    const auto closest_approach = dot(x, y, z, direction_x, direction_y, direction_z);
    const auto half_chord_squared =
        hn::Add(hn::Sub(radius_squared, distance_squared), hn::Mul(closest_approach, closest_approach));
    const auto behind = hn::And(hn::Ge(distance_squared, radius_squared), hn::Lt(closest_approach, epsilon));
    met = hn::AndNot(behind, hn::Gt(half_chord_squared, epsilon));
    // Going on when nothing is met is cheaper than a branch that cannot be foretold.
    const auto half_chord = hn::Sqrt(half_chord_squared);
    enters = hn::Sub(closest_approach, half_chord);
    leaves = hn::Add(closest_approach, half_chord);
  }
};

/// Bits of the spheres with a crossing that counts, not beyond `max_depth`; `depths` gets the nearest of each, infinite
/// where there is none. As ExactRay has it, a crossing before the ray enters the sphere's box does not count.
HWY_INLINE unsigned meet_spheres(const SphereBlock& block, const RayBlock& rays, const FloatRays& float_rays,
                                 std::size_t ray, double max_depth, double* HWY_RESTRICT depths) {
  const Doubles d;
  const hn::Rebind<float, Doubles> narrow;
  const auto all = [&](const Column<double>& column) HWY_ATTR { return hn::Set(d, column[ray]); };
  const auto& origin = rays.origin.of;
  const auto& direction = rays.direction.of;
  unsigned bits = 0;
  for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(d)) {
    const auto x = hn::Sub(hn::Load(d, block.center[0] + lane), all(origin[0]));
    const auto y = hn::Sub(hn::Load(d, block.center[1] + lane), all(origin[1]));
    const auto z = hn::Sub(hn::Load(d, block.center[2] + lane), all(origin[2]));
    const SphereMeeting meeting(x, y, z, hn::Load(d, block.radius_squared + lane), all(direction[0]), all(direction[1]),
                                all(direction[2]));
    const auto met = meeting.met;
    const auto enters = meeting.enters;
    const auto leaves = meeting.leaves;
    const auto last = hn::Set(d, max_depth);
    const auto near_enough = hn::And(met, hn::Le(enters, last));
    if (hn::AllFalse(d, hn::And(near_enough, hn::Gt(leaves, all(rays.min_depth))))) {
      hn::Store(hn::Set(d, std::numeric_limits<double>::infinity()), d, depths + lane);
      continue;
    }
    auto from = all(rays.min_depth);
    auto until = hn::Set(d, ExactRay::kEndless);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float* faces = block.bounds[2 * axis] + lane;
      const std::size_t near = float_rays.near_row.of[axis][ray];
      const auto near_face = hn::PromoteTo(d, hn::Load(narrow, faces + near));
      const auto far_face = hn::PromoteTo(d, hn::Load(narrow, faces + (near ^ kLanes)));
      const auto inverse = all(float_rays.exact_inverse.of[axis]);
      from = hn::Max(from, hn::Mul(hn::Sub(near_face, all(origin[axis])), inverse));
      until = hn::Min(until, hn::Mul(hn::Sub(far_face, all(origin[axis])), inverse));
    }
    const auto boxed = hn::And(near_enough, hn::Le(from, hn::Mul(until, hn::Set(d, ExactRay::kAway))));
    const auto counts = [&](hn::VFromD<Doubles> depth) HWY_ATTR {
      const auto within = hn::And(hn::Gt(depth, hn::Set(d, kNearestCrossing)), hn::Lt(depth, hn::Set(d, kMaxDistance)));
      const auto beyond = hn::And(hn::Gt(depth, all(rays.min_depth)), hn::Ge(depth, from));
      return hn::And(within, hn::And(beyond, hn::Le(depth, last)));
    };
    const auto first = hn::And(boxed, counts(enters));
    const auto any = hn::Or(first, hn::And(boxed, counts(leaves)));
    const auto depth = hn::IfThenElse(first, enters, leaves);
    hn::Store(hn::IfThenElse(any, depth, hn::Set(d, std::numeric_limits<double>::infinity())), d, depths + lane);
    bits |= bits_of(d, any) << lane;
  }
  return bits;
}

/// Without those that the ray does not see.
HWY_INLINE unsigned seen(const SphereBlock& block, unsigned bits, std::int64_t hidden_bit) {
  if ((block.hidden_from_any & hidden_bit) == 0) return bits;
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    if ((block.hidden_from[lane] & hidden_bit) != 0) bits &= ~(1u << lane);
  }
  return bits;
}

/// `heads`: of the block's lanes.
template <class Search>
HWY_INLINE void meet_leaf(const SphereBlock& block, const LeafHead* heads, std::size_t ray, Search& search) {
  alignas(64) double depths[kLanes];
  unsigned bits = meet_spheres(block, search.rays(), search.float_rays(), ray, search.limit(ray), depths);
  if (Search::kAsksForOpaque) bits &= block.opaque;
  for (bits = seen(block, bits, search.rays().hidden_bit[ray]); bits != 0; bits &= bits - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(bits));
    search.offer(ray, depths[lane], 0, {}, heads[lane], 0.0);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
