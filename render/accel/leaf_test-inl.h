// How a ray meets spheres and planes, several at once. Included once for each instruction set, so the guard switches
// back and forth. Lane by lane the operations are those of meet_sphere and Plane::meet in the same order, none fused:
// the depths are the same to the bit.
#if defined(FIRSTLIGHT_RENDER_ACCEL_LEAF_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_ACCEL_LEAF_TEST_INL_H
#undef FIRSTLIGHT_RENDER_ACCEL_LEAF_TEST_INL_H
#else
#define FIRSTLIGHT_RENDER_ACCEL_LEAF_TEST_INL_H
#endif

#include "render/accel/box_test-inl.h"
#include "render/accel/leaves.h"

#include <hwy/highway.h>

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, kLanes>;

/// a . b as Vec3::dot has it.
template <class V>
HWY_INLINE V dot(const V& ax, const V& ay, const V& az, const V& bx, const V& by, const V& bz) {
  return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

/// Where a ray passes through the spheres of a block.
struct SphereCrossings {
  alignas(64) double enters[kLanes];
  alignas(64) double leaves[kLanes];
};

/// Bits of the spheres with a crossing that may lie between the query's min_depth and `max_depth`, both included.
HWY_INLINE unsigned meet_spheres(const SphereBlock& block, const RayQuery& query, double max_depth,
                                 SphereCrossings& out) {
  const Doubles d;
  const Ray& ray = query.ray;
  unsigned bits = 0;
  for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(d)) {
    const auto x = hn::Sub(hn::Load(d, block.center[0] + lane), hn::Set(d, ray.origin.x));
    const auto y = hn::Sub(hn::Load(d, block.center[1] + lane), hn::Set(d, ray.origin.y));
    const auto z = hn::Sub(hn::Load(d, block.center[2] + lane), hn::Set(d, ray.origin.z));
    const auto radius_squared = hn::Load(d, block.radius_squared + lane);
    const auto epsilon = hn::Set(d, kEpsilon);
    const auto distance_squared = dot(x, y, z, x, y, z);
    const auto closest_approach =
        dot(x, y, z, hn::Set(d, ray.direction.x), hn::Set(d, ray.direction.y), hn::Set(d, ray.direction.z));
    const auto half_chord_squared =
        hn::Add(hn::Sub(radius_squared, distance_squared), hn::Mul(closest_approach, closest_approach));
    const auto behind = hn::And(hn::Ge(distance_squared, radius_squared), hn::Lt(closest_approach, epsilon));
    const auto met = hn::AndNot(behind, hn::Gt(half_chord_squared, epsilon));
    // Going on when nothing is met is cheaper than a branch that cannot be foretold.
    const auto half_chord = hn::Sqrt(half_chord_squared);
    const auto enters = hn::Sub(closest_approach, half_chord);
    const auto leaves = hn::Add(closest_approach, half_chord);
    const auto within = hn::And(hn::Ge(leaves, hn::Set(d, query.min_depth)), hn::Le(enters, hn::Set(d, max_depth)));
    hn::Store(enters, d, out.enters + lane);
    hn::Store(leaves, d, out.leaves + lane);
    bits |= bits_of(d, hn::And(met, within)) << lane;
  }
  return bits;
}

/// Bits of the planes that the ray meets beyond the query's min_depth and not beyond `max_depth`. The depths of the
/// others are infinite.
HWY_INLINE unsigned meet_planes(const PlaneBlock& block, const RayQuery& query, double max_depth,
                                double* HWY_RESTRICT depths) {
  const Doubles d;
  const Ray& ray = query.ray;
  unsigned bits = 0;
  for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(d)) {
    const auto x = hn::Load(d, block.normal[0] + lane);
    const auto y = hn::Load(d, block.normal[1] + lane);
    const auto z = hn::Load(d, block.normal[2] + lane);
    const auto approach =
        dot(x, y, z, hn::Set(d, ray.direction.x), hn::Set(d, ray.direction.y), hn::Set(d, ray.direction.z));
    const auto from_origin = dot(x, y, z, hn::Set(d, ray.origin.x), hn::Set(d, ray.origin.y), hn::Set(d, ray.origin.z));
    const auto depth = hn::Div(hn::Neg(hn::Add(from_origin, hn::Load(d, block.offset + lane))), approach);
    const auto near = hn::And(hn::Ge(depth, hn::Set(d, kNearestCrossing)), hn::Gt(depth, hn::Set(d, query.min_depth)));
    const auto far = hn::Le(depth, hn::Set(d, std::min(kMaxDistance, max_depth)));
    const auto met = hn::And(hn::Ge(hn::Abs(approach), hn::Set(d, kEpsilon)), hn::And(near, far));
    hn::Store(hn::IfThenElse(met, depth, hn::Set(d, std::numeric_limits<double>::infinity())), d, depths + lane);
    bits |= bits_of(d, met) << lane;
  }
  return bits;
}

/// The first lane of the smallest.
HWY_INLINE std::size_t least_of(const double* HWY_RESTRICT depths) {
  const Doubles d;
  auto least = hn::Load(d, depths);
  for (std::size_t lane = hn::Lanes(d); lane < kLanes; lane += hn::Lanes(d)) {
    least = hn::Min(least, hn::Load(d, depths + lane));
  }
  least = hn::MinOfLanes(d, least);
  unsigned bits = 0;
  for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(d)) {
    bits |= bits_of(d, hn::Eq(hn::Load(d, depths + lane), least)) << lane;
  }
  return static_cast<std::size_t>(__builtin_ctz(bits));
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
