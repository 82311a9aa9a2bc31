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
#include "render/lanes/lanes-inl.h"

#include <hwy/highway.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
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

/// The rays in `who` one by one.
template <class Search>
HWY_NOINLINE void meet_singly(const SolidLeaf& leaf, std::uint64_t who, const Column<double>& from, Search& search) {
  const RayBlock& rays = search.rays();
  std::vector<Crossing>& scratch = scratch_of_thread();
  for (; who != 0; who &= who - 1) {
    const auto ray = static_cast<std::size_t>(__builtin_ctzll(who));
    scratch.clear();
    const double low = least_depth(rays.min_depth[ray], leaf.is_cramped ? 0.0 : from[ray]);
    const auto hidden_bit = static_cast<std::uint8_t>(rays.hidden_bit[ray]);
    leaf.geometry->nearest(rays.ray(ray), hidden_bit, low, search.limit(ray), scratch);
    search.offer_all(ray, scratch, leaf, from[ray]);
  }
}

/// The depths between which crossings count: as least_depth() has it, and not beyond the search's limit.
template <class Search>
HWY_INLINE void find_window(const SolidLeaf& leaf, const Column<double>& from, const Search& search,
                            Column<double>& low, Column<double>& high) {
  const RayBlock& rays = search.rays();
  for (std::size_t i = 0; i < rays.size; i += Lanes::kCount) {
    const auto min_depth = load<Lanes>(rays.min_depth, i);
    const auto entered = leaf.is_cramped ? min_depth : load<Lanes>(from, i);
    store(select(entered > min_depth, add_to_bits(entered, -1), min_depth), low, i);
    const auto limit = load<Lanes>(search.limits(), i);
    // A feeler is blocked only before its end.
    store(Search::kAsksForOpaque ? add_to_bits(limit, -1) : limit, high, i);
  }
}

/// The rays in `who`, all of a kind, together. False: none has been met.
template <class Search>
HWY_NOINLINE bool meet_block(const SolidLeaf& leaf, std::uint64_t who, std::uint8_t hidden_bit,
                             const Column<double>& from, Search& search) {
  const RayBlock& rays = search.rays();
  Column<double> low, high;
  find_window(leaf, from, search, low, high);
  const BlockQuestion question{rays, search.float_rays().exact_inverse, DepthWindow{low, high},
                               Search::kAsksForOpaque ? &search.leaves().opaque_parts : nullptr};
  Slots& slots = Slots::of_thread();
  NearestCrossings nearest;
  if (!leaf.geometry->meet(question, hidden_bit, who, slots, nearest)) return false;
  for (std::uint64_t bits = nearest.rays; bits != 0; bits &= bits - 1) {
    const auto ray = static_cast<std::size_t>(__builtin_ctzll(bits));
    search.offer_nearest(ray, nearest.depth[ray], slots[nearest.slot_of(ray)], leaf, from[ray]);
  }
  return true;
}

/// One ray or two are met one by one.
template <class Search>
HWY_INLINE void meet_leaf(const SolidLeaf& leaf, std::uint64_t who, Search& search) {
  if (leaf.only_blocks && !Search::kAsksForOpaque) return;
  Column<double> from;
  who = entering(leaf.bounds, search.seeing(who, leaf.head), search, from);
  if (who == 0) return;
  const std::uint64_t but_one = who & (who - 1);
  if (!leaf.in_blocks || (but_one & (but_one - 1)) == 0) return meet_singly(leaf, who, from, search);
  if (!leaf.geometry->hides_some()) {
    if (!meet_block(leaf, who, 0, from, search)) meet_singly(leaf, who, from, search);
    return;
  }
  while (who != 0) {
    const auto& kinds = search.rays().hidden_bit;
    const std::int64_t kind = kinds[static_cast<std::size_t>(__builtin_ctzll(who))];
    std::uint64_t alike = 0;
    for (std::uint64_t bits = who; bits != 0; bits &= bits - 1) {
      if (kinds[static_cast<std::size_t>(__builtin_ctzll(bits))] == kind) alike |= bits & -bits;
    }
    who &= ~alike;
    if (!meet_block(leaf, alike, static_cast<std::uint8_t>(kind), from, search)) meet_singly(leaf, alike, from, search);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
