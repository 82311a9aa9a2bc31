// How rays meet a box, over a lane type. Included once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_SHAPE_BOX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_SHAPE_BOX_INL_H
#undef FIRSTLIGHT_RENDER_SHAPE_BOX_INL_H
#else
#define FIRSTLIGHT_RENDER_SHAPE_BOX_INL_H
#endif

#include "render/shape/box.h"
#include "render/shape/lane_shape-inl.h"
#include "render/shape/tolerance.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// A side that rays come to, on their way in or out.
template <class L>
struct BoxSide {
  L depth;
  L face;
  L squareness;  ///< how squarely it is met: the size of the direction along its axis
};

template <class L, class Sink>
HWY_INLINE void meet(const AxisBox& box, const RayOf<L>& ray, const Sink& met) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  BoxSide<L> in{0.0, -1.0, kNone};
  BoxSide<L> out{kBoundingHuge, -1.0, kNone};
  auto alive = L::first(L::kCount);
  const auto pass = [&](const L& o, const L& d, double low, double high, double axis) HWY_ATTR {
    const double close = axis == 0.0 ? 0.0 : 1e-6;
    const L size = abs(d);
    const auto slanted = size > kEpsilon;
    const auto upwards = d > 0.0;
    const L leaves = (select(upwards, L(high), L(low)) - o) / d;
    const L enters = (select(upwards, L(low), L(high)) - o) / d;
    const auto beside = (o < low) | (o > high);
    alive = without(alive, (slanted & (leaves < in.depth)) | without(beside, slanted));

    const auto nearer = leaves <= out.depth - close;
    const auto leaves_there = slanted & (nearer | ((leaves <= out.depth + close) & (size > out.squareness)));
    out.face = select(leaves_there, select(upwards, L(2.0 * axis + 1.0), L(2.0 * axis)), out.face);
    out.squareness = select(leaves_there, size, out.squareness);
    out.depth = select(slanted & nearer, leaves, out.depth);

    const auto farther = enters >= in.depth + close;
    alive = without(alive, slanted & farther & (enters > out.depth));
    const auto enters_there = slanted & (farther | ((enters >= in.depth - close) & (size > in.squareness)));
    in.face = select(enters_there, select(upwards, L(2.0 * axis), L(2.0 * axis + 1.0)), in.face);
    in.squareness = select(enters_there, size, in.squareness);
    in.depth = select(slanted & farther, enters, in.depth);
  };
  pass(ray.origin.x, ray.direction.x, box.low.x, box.high.x, 0.0);
  pass(ray.origin.y, ray.direction.y, box.low.y, box.high.y, 1.0);
  pass(ray.origin.z, ray.direction.z, box.low.z, box.high.z, 2.0);
  alive = without(alive, (out.depth < kNearestCrossing) | (out.face < 0.0));
  if (!any(alive)) return;
  met(0, in.depth, alive & (in.depth > kNearestCrossing), in.face);
  met(1, out.depth, alive, out.face);
}

template <class L>
HWY_INLINE MaskOf<L> inside(const AxisBox& box, const Vec3Of<L>& p, bool inverted) {
  const auto outside = (p.x < box.low.x) | (p.x > box.high.x) | (p.y < box.low.y) | (p.y > box.high.y) |
                       (p.z < box.low.z) | (p.z > box.high.z);
  return inverted ? outside : !outside;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
