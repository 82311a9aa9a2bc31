// How several rays meet a plane. Lane by lane the operations are those of the shape Plane in the same order, none fused:
// the depths are the same to the bit.
// Included once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_ACCEL_LEAF_PLANE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_ACCEL_LEAF_PLANE_INL_H
#undef FIRSTLIGHT_RENDER_ACCEL_LEAF_PLANE_INL_H
#else
#define FIRSTLIGHT_RENDER_ACCEL_LEAF_PLANE_INL_H
#endif

#include "render/accel/box_test-inl.h"
#include "render/accel/leaf/doubles-inl.h"
#include "render/accel/leaf/plane.h"
#include "render/accel/ray_block.h"
#include "render/shape/tolerance.h"

#include <hwy/highway.h>

#include <vector>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Several rays, and where they go from the plane.
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
      // The first of equal depths is of the lowest solid.
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
