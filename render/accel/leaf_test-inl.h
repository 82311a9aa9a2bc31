// How a ray meets several spheres at once, and several rays a plane. Included once for each instruction set, so the
// guard switches back and forth. Lane by lane the operations are those of meet_sphere and Plane::meet in the same
// order, none fused: the depths are the same to the bit.
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

/// Several rays and what Plane::meet has of them.
struct PlaneMeeting {
  using V = hn::VFromD<Doubles>;
  using M = decltype(hn::Eq(V(), V()));

  V approach;  ///< of the directions to the normal
  V height;    ///< of the origins above the plane

  HWY_INLINE PlaneMeeting(const PlaneLeaf& plane, const RayBlock& rays, std::size_t i) {
    const Doubles d;
    const auto x = hn::Set(d, plane.normal.x);
    const auto y = hn::Set(d, plane.normal.y);
    const auto z = hn::Set(d, plane.normal.z);
    const auto load = [&](const Column<double>& column) HWY_ATTR { return hn::Load(d, column.at.data() + i); };
    const auto& direction = rays.direction.of;
    const auto& origin = rays.origin.of;
    approach = dot(x, y, z, load(direction[0]), load(direction[1]), load(direction[2]));
    height = hn::Add(dot(x, y, z, load(origin[0]), load(origin[1]), load(origin[2])), hn::Set(d, plane.offset));
  }

  HWY_INLINE V depth() const { return hn::Div(hn::Neg(height), approach); }
  /// Whether a crossing there counts, beyond `min_depth`.
  HWY_INLINE M counts(V depth, V min_depth) const {
    const Doubles d;
    const auto near = hn::And(hn::Ge(depth, hn::Set(d, kNearestCrossing)), hn::Gt(depth, min_depth));
    const auto far = hn::Le(depth, hn::Set(d, kMaxDistance));
    return hn::And(hn::Ge(hn::Abs(approach), hn::Set(d, kEpsilon)), hn::And(near, far));
  }
  /// False where the depth is not between the two, which are not negative; without the division. The products are off
  /// by less than their 2^-52nd part.
  HWY_INLINE M may_be_between(V low, V high) const {
    const Doubles d;
    const auto size = hn::Abs(approach);
    // height / -approach, with the sign in the numerator.
    const auto way = hn::Neg(hn::CopySign(height, hn::Xor(height, approach)));
    const auto less = hn::Mul(hn::Mul(low, size), hn::Set(d, 1.0 - 0x1p-49));
    const auto more = hn::Mul(hn::Mul(high, size), hn::Set(d, 1.0 + 0x1p-49));
    return hn::And(hn::Ge(way, less), hn::Le(way, more));
  }
};

/// Where a ray meets its nearest plane.
struct PlaneHits {
  Column<double> depth;        ///< the ray's max_depth where it meets none
  Column<std::int64_t> plane;  ///< -1 where it meets none
};

/// Lanes whose ray does not see what hides from `hidden_from`.
HWY_INLINE PlaneMeeting::M hidden_lanes(const RayBlock& rays, std::size_t i, std::uint8_t hidden_from) {
  const Doubles d;
  const hn::RebindToSigned<Doubles> di;
  const auto bits = hn::And(hn::Load(di, rays.hidden_bit.at.data() + i), hn::Set(di, hidden_from));
  return hn::RebindMask(d, hn::Ne(bits, hn::Zero(di)));
}

HWY_INLINE void meet_planes(const std::vector<PlaneLeaf>& planes, const RayBlock& rays, PlaneHits& hits) {
  const Doubles d;
  const hn::RebindToSigned<Doubles> di;
  for (std::size_t i = 0; i < rays.size; i += hn::Lanes(d)) {
    const auto min_depth = hn::Load(d, rays.min_depth.at.data() + i);
    auto nearest = hn::Load(d, rays.max_depth.at.data() + i);
    auto which = hn::Set(di, -1);
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const PlaneMeeting meeting(planes[p], rays, i);
      const auto depth = meeting.depth();
      // Of equal depths the first is of the lowest solid.
      auto met = hn::And(meeting.counts(depth, min_depth), hn::Lt(depth, nearest));
      if (planes[p].head.hidden_from != 0) met = hn::AndNot(hidden_lanes(rays, i, planes[p].head.hidden_from), met);
      nearest = hn::IfThenElse(met, depth, nearest);
      which = hn::IfThenElse(hn::RebindMask(di, met), hn::Set(di, static_cast<std::int64_t>(p)), which);
    }
    hn::Store(nearest, d, hits.depth.at.data() + i);
    hn::Store(which, di, hits.plane.at.data() + i);
  }
}

/// Bits of the rays that opaque planes block.
HWY_INLINE std::uint64_t blocked_by_planes(const std::vector<PlaneLeaf>& planes, const RayBlock& rays) {
  const Doubles d;
  std::uint64_t blocked = 0;
  for (std::size_t i = 0; i < rays.size; i += hn::Lanes(d)) {
    const auto min_depth = hn::Load(d, rays.min_depth.at.data() + i);
    const auto max_depth = hn::Load(d, rays.max_depth.at.data() + i);
    const auto low = hn::Max(min_depth, hn::Set(d, kNearestCrossing));
    for (const PlaneLeaf& plane : planes) {
      if (!plane.head.opaque) continue;
      const PlaneMeeting meeting(plane, rays, i);
      if (hn::AllFalse(d, meeting.may_be_between(low, max_depth))) continue;
      const auto depth = meeting.depth();
      auto met = hn::And(meeting.counts(depth, min_depth), hn::Lt(depth, max_depth));
      if (plane.head.hidden_from != 0) met = hn::AndNot(hidden_lanes(rays, i, plane.head.hidden_from), met);
      blocked |= std::uint64_t{bits_of(d, met)} << i;
    }
  }
  return blocked & rays.all();
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
