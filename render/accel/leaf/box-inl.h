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
#include "render/shape/box-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Where rays of one vector come into the box and leave it.
struct BoxCrossings {
  Lanes depth[2];
  Lanes face[2];
  LanesMask met[2];
};
struct BoxSink {
  BoxCrossings* crossings;

  HWY_INLINE void operator()(std::size_t k, const Lanes& depth, const LanesMask& met, const Lanes& face) const {
    crossings->depth[k] = depth;
    crossings->face[k] = face;
    crossings->met[k] = met;
  }
};

template <class Search>
HWY_INLINE void meet_leaf(const BoxLeaf& leaf, std::uint64_t who, Search& search) {
  Column<double> from;
  who = entering(leaf.bounds, search.seeing(who, leaf.head), search, from);
  const RayBlock& rays = search.rays();
  Column<double> depth, face;
  std::uint64_t met = 0;
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    const std::uint64_t of_vector = who >> i & kAllLanes;
    if (of_vector == 0) continue;
    const LanesMask none = Lanes::first(0);
    BoxCrossings box{{0.0, 0.0}, {0.0, 0.0}, {none, none}};
    meet(leaf.box, RayOf<Lanes>{load3<Lanes>(rays.origin, i), load3<Lanes>(rays.direction, i)}, BoxSink{&box});
    const auto low = load<Lanes>(rays.min_depth, i);
    const auto entered = load<Lanes>(from, i);
    const auto limit = load<Lanes>(search.limits(), i);
    for (std::size_t k = 0; k < 2; ++k) {
      box.met[k] = box.met[k] & (box.depth[k] > low) & (box.depth[k] >= entered) & (box.depth[k] <= limit);
    }
    // The last of equal depths is seen, as with all crossings of one solid.
    const auto first = box.met[0] & (!box.met[1] | (box.depth[0] < box.depth[1]));
    store(select(first, box.depth[0], box.depth[1]), depth, i);
    store(select(first, box.face[0], box.face[1]), face, i);
    met |= (bits(box.met[0] | box.met[1]) & of_vector) << i;
  }
  for (; met != 0; met &= met - 1) {
    const auto ray = static_cast<std::size_t>(__builtin_ctzll(met));
    search.offer(ray, depth[ray], static_cast<std::uint32_t>(face[ray]), {}, leaf.head, from[ray]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
