// Where rays of a block come into the box of one leaf.
// Included once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_ACCEL_LEAF_ENTERING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_ACCEL_LEAF_ENTERING_INL_H
#undef FIRSTLIGHT_RENDER_ACCEL_LEAF_ENTERING_INL_H
#else
#define FIRSTLIGHT_RENDER_ACCEL_LEAF_ENTERING_INL_H
#endif

#include "render/accel/box_test-inl.h"
#include "render/accel/float_box.h"
#include "render/accel/leaf/doubles-inl.h"
#include "render/accel/ray_block.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The bits of those rays in `who` that meet the box not beyond the search's limit; `from` gets where they enter it.
/// ExactRay::meets() lane by lane, to the bit.
template <class Search>
HWY_INLINE std::uint64_t entering(const FloatBox& box, std::uint64_t who, const Search& search, Column<double>& from) {
  const Doubles d;
  constexpr std::uint64_t kVector = (std::uint64_t{1} << hn::MaxLanes(Doubles())) - 1;
  const RayBlock& rays = search.rays();
  std::uint64_t entering = 0;
  for (std::size_t i = 0; i < kRaysAtOnce; i += hn::Lanes(d)) {
    const std::uint64_t of_vector = who >> i & kVector;
    if (of_vector == 0) continue;
    const auto load = [&](const Column<double>& column) HWY_ATTR { return hn::Load(d, column.at.data() + i); };
    auto near = load(rays.min_depth);
    auto leave = hn::Set(d, ExactRay::kEndless);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto origin = load(rays.origin.of[axis]);
      const auto inverse = load(search.float_rays().exact_inverse.of[axis]);
      const auto at_low = hn::Mul(hn::Sub(hn::Set(d, box.low[axis]), origin), inverse);
      const auto at_high = hn::Mul(hn::Sub(hn::Set(d, box.high[axis]), origin), inverse);
      const auto downwards = hn::Lt(inverse, hn::Zero(d));
      const auto enters = hn::IfThenElse(downwards, at_high, at_low);
      const auto leaves = hn::IfThenElse(downwards, at_low, at_high);
      near = hn::IfThenElse(hn::Lt(near, enters), enters, near);
      leave = hn::IfThenElse(hn::Lt(leaves, leave), leaves, leave);
    }
    hn::Store(near, d, from.at.data() + i);
    const auto met =
        hn::And(hn::Le(near, hn::Mul(leave, hn::Set(d, ExactRay::kAway))), hn::Le(near, load(search.limits())));
    entering |= (bits_of(d, met) & of_vector) << i;
  }
  return entering;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
