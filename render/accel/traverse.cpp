#include "render/accel/leaves.h"

// This file is compiled once for each instruction set; the best one that the machine has is chosen at run time. What
// differs between them is which children of nodes are visited, never which crossings count.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/accel/traverse.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "render/accel/search-inl.h"
#include "render/math/interrupt.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Pairs of a ray and what it is to visit. Whole vectors are stored, so there is room beyond the last pair.
template <std::size_t kMost>
struct Visits {
  std::uint32_t ray[kMost + kTreeWidth];
  std::uint32_t ref[kMost + kTreeWidth];
};

/// How many pairs are taken at a time: none waits for another, so the processor works on several at once.
constexpr std::size_t kTogether = 16;
/// Between two questions whether to go on; a turn takes a microsecond or less, but for what solids need.
constexpr unsigned kTurnsBetween = 256;
/// At so many leaves rays do not wait for more rays any longer: what they meet there spares them other leaves.
constexpr std::size_t kMostWaiting = 64;
using LeafVisits = Visits<kTogether * kTreeWidth>;
/// The pairs taken are opened from the bottom of the stack to its top, so that the nodes on it lie by their depth.
/// Pairs of a depth come only when those of the depth above are taken, which lie below: there are never more of a depth
/// than the children of so many.
using NodeVisits = Visits<kRaysAtOnce + kTogether * kTreeWidth * kTreeDepth>;

/// All rays that may meet something in the tree, through the tree together.
template <class Search>
HWY_INLINE void walk_together(const WideTree& tree, const FloatRays& rays, LeafGroups& waiting, Search& search) {
  static_assert(static_cast<std::uint32_t>(ChildKind::node) == 0 && sizeof(ChildRef) == sizeof(std::uint32_t));
  const hn::CappedTag<float, kTreeWidth> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  NodeVisits nodes;
  LeafVisits leaves;
  // Beside their lists, not in them: the compiler keeps these in registers.
  std::size_t node_count = 0;
  for (std::uint64_t bits = rays.near; bits != 0; bits &= bits - 1) {
    nodes.ray[node_count] = static_cast<std::uint32_t>(__builtin_ctzll(bits));
    nodes.ref[node_count++] = 0;
  }
  for (unsigned turns = 1; node_count != 0; ++turns) {
    if (turns % kTurnsBetween == 0 && Interrupt::asked()) return;
    const std::size_t taken = std::min(node_count, kTogether);
    node_count -= taken;
    std::uint32_t ray[kTogether];
    std::uint32_t node[kTogether];
    std::copy_n(nodes.ray + node_count, kTogether, ray);
    std::copy_n(nodes.ref + node_count, kTogether, node);
    std::size_t leaf_count = 0;
    for (std::size_t p = 0; p < taken; ++p) {
      const WideNode& opened = tree.nodes()[node[p]];
      const auto ray_number = hn::Set(du, ray[p]);
      for (std::size_t slot = 0; slot < kTreeWidth; slot += hn::Lanes(d)) {
        const auto met = hn::RebindMask(du, meet_children(opened, slot, rays, ray[p]));
        const auto refs = hn::Load(du, reinterpret_cast<const std::uint32_t*>(opened.child) + slot);
        const auto is_node = hn::Eq(hn::ShiftRight<ChildRef::kIndexBits>(refs), hn::Zero(du));
        const auto inner = hn::And(met, is_node);
        const auto outer = hn::AndNot(is_node, met);
        hn::StoreU(hn::Compress(refs, inner), du, nodes.ref + node_count);
        hn::StoreU(ray_number, du, nodes.ray + node_count);
        node_count += hn::CountTrue(du, inner);
        hn::StoreU(hn::Compress(refs, outer), du, leaves.ref + leaf_count);
        hn::StoreU(ray_number, du, leaves.ray + leaf_count);
        leaf_count += hn::CountTrue(du, outer);
      }
    }
    for (std::size_t l = 0; l < leaf_count; ++l) {
      visit(search.leaves(), leaves.ray[l], ChildRef{leaves.ref[l]}, waiting, search);
    }
    if (waiting.leaves().size() >= kMostWaiting) meet_waiting(waiting, search);
  }
}

/// For the rare rays that floats do not suit: one alone.
template <class Search>
HWY_NOINLINE void walk_exactly(const WideTree& tree, const ExactRay& ray, std::size_t i, LeafGroups& waiting,
                               Search& search) {
  std::uint32_t stack[kTreeDepth * (kTreeWidth - 1) + kTreeWidth];
  std::size_t size = 0;
  stack[size++] = 0;
  while (size != 0) {
    const WideNode& node = tree.nodes()[stack[--size]];
    for (unsigned bits = ray.meet_children(node, search.limit(i)); bits != 0; bits &= bits - 1) {
      const ChildRef ref = node.child[__builtin_ctz(bits)];
      if (ref.kind() == ChildKind::node) {
        stack[size++] = ref.index();
      } else {
        visit(search.leaves(), i, ref, waiting, search);
      }
    }
  }
}

/// All rays of the block but those in `done`.
template <class Search>
HWY_INLINE void walk(const Leaves& leaves, const RayBlock& rays, FloatRays& float_rays, std::uint64_t done,
                     Search& search) {
  const std::uint64_t all = rays.all() & ~done;
  LeafGroups& waiting = LeafGroups::of_thread();
  waiting.make_room(std::max(leaves.solids.size(), leaves.boxes.size()));
  if (!leaves.tree.nodes().empty()) {
    float_rays.near &= all;
    walk_together(leaves.tree, float_rays, waiting, search);
    for (std::uint64_t bits = all & ~float_rays.usable; bits != 0 && !Interrupt::asked(); bits &= bits - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(bits));
      walk_exactly(leaves.tree, ExactRay(rays, float_rays.exact_inverse, i), i, waiting, search);
    }
    meet_waiting(waiting, search);
  }
  for (const ChildRef ref : leaves.beside) {
    if (Interrupt::asked()) return;
    if (ref.kind() != ChildKind::sphere) {
      meet_together(leaves, all, ref, search);
      continue;
    }
    for (std::uint64_t bits = all; bits != 0; bits &= bits - 1) {
      visit(leaves, static_cast<std::size_t>(__builtin_ctzll(bits)), ref, waiting, search);
    }
  }
}

/// Bits of the rays for which another solid lies where the hit is.
std::uint64_t closest_of_block(const Leaves& leaves, const RayBlock& rays, std::span<Hit> hits) {
  PlaneHits planes;
  meet_planes(leaves.planes, rays, planes);
  FloatRays float_rays(rays, planes.depth, leaves.tree);
  ClosestSearch search(leaves, rays, float_rays, hits);
  for (std::size_t i = 0; i < rays.size; ++i) search.begin(i, planes.plane[i], planes.depth[i]);
  walk(leaves, rays, float_rays, 0, search);
  std::uint64_t in_doubt = 0;
  for (std::size_t i = 0; i < rays.size; ++i) {
    if (hits[i].part == kNoIndex) {
      hits[i] = Hit();
    } else if (search.in_doubt(i)) {
      in_doubt |= std::uint64_t{1} << i;
    }
  }
  search.put_back();
  return in_doubt;
}

std::uint64_t occluded_of_block(const Leaves& leaves, const RayBlock& rays) {
  const std::uint64_t blocked = blocked_by_planes(leaves.planes, rays);
  FloatRays float_rays(rays, rays.max_depth, leaves.tree);
  BlockingSearch search(leaves, rays, float_rays);
  walk(leaves, rays, float_rays, blocked, search);
  return blocked | search.blocked();
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(closest_of_block);
HWY_EXPORT(occluded_of_block);

void find_closest(const Leaves& leaves, const RayBlock& rays, std::span<Hit> hits) {
  std::uint64_t in_doubt = HWY_DYNAMIC_DISPATCH(closest_of_block)(leaves, rays, hits);
  for (; in_doubt != 0; in_doubt &= in_doubt - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(in_doubt));
    hits[i] = leaves.tie_order.seen(rays, i);
  }
}

std::uint64_t find_occluded(const Leaves& leaves, const RayBlock& rays) {
  return HWY_DYNAMIC_DISPATCH(occluded_of_block)(leaves, rays);
}

}  // namespace firstlight::render
#endif
