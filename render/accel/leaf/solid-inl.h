// How rays meet any solid.
// Included once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_ACCEL_LEAF_SOLID_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_ACCEL_LEAF_SOLID_INL_H
#undef FIRSTLIGHT_RENDER_ACCEL_LEAF_SOLID_INL_H
#else
#define FIRSTLIGHT_RENDER_ACCEL_LEAF_SOLID_INL_H
#endif

#include "render/accel/box_test-inl.h"
#include "render/accel/leaf/entering-inl.h"
#include "render/accel/leaf/solid.h"
#include "render/accel/ray_block.h"

#include <hwy/highway.h>

#include <cmath>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline std::vector<Crossing>& scratch_of_thread() {
  thread_local std::vector<Crossing> scratch;
  return scratch;
}

/// Beyond which crossings count: those that are not before a leaf's box either.
HWY_INLINE double least_depth(double min_depth, double from) {
  return from > min_depth ? std::nextafter(from, 0.0) : min_depth;
}

template <class Search>
HWY_INLINE void meet_leaf(const SolidLeaf& leaf, std::uint64_t who, Search& search) {
  if (leaf.only_blocks && !Search::kAsksForOpaque) return;
  Column<double> from;
  who = entering(leaf.bounds, search.seeing(who, leaf.head), search, from);
  const RayBlock& rays = search.rays();
  std::vector<Crossing>& scratch = scratch_of_thread();
  for (; who != 0; who &= who - 1) {
    const auto ray = static_cast<std::size_t>(__builtin_ctzll(who));
    scratch.clear();
    const double low = least_depth(rays.min_depth[ray], leaf.is_cramped ? 0.0 : from[ray]);
    const auto hidden_bit = static_cast<std::uint8_t>(rays.hidden_bit[ray]);
    leaf.geometry->nearest(search.ray(ray), hidden_bit, low, search.limit(ray), scratch);
    search.offer_all(ray, scratch, leaf, from[ray]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
