// How rays meet a box along the axes.
// Included once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_ACCEL_LEAF_BOX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_ACCEL_LEAF_BOX_INL_H
#undef FIRSTLIGHT_RENDER_ACCEL_LEAF_BOX_INL_H
#else
#define FIRSTLIGHT_RENDER_ACCEL_LEAF_BOX_INL_H
#endif

#include "render/accel/box_test-inl.h"
#include "render/accel/leaf/box.h"
#include "render/accel/leaf/entering-inl.h"
#include "render/accel/ray_block.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class Search>
HWY_INLINE void meet_leaf(const BoxLeaf& leaf, std::uint64_t who, Search& search) {
  Column<double> from;
  who = entering(leaf.bounds, search.seeing(who, leaf.head), search, from);
  for (; who != 0; who &= who - 1) {
    const auto ray = static_cast<std::size_t>(__builtin_ctzll(who));
    BoxMet met;
    leaf.box.meet(search.ray(ray), met);
    // The last first, as crossings of one solid are offered.
    for (std::size_t m = met.count; m-- > 0;) search.offer(ray, met.depth[m], met.face[m], {}, leaf.head, from[ray]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
