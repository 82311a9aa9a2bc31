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

#include "render/accel/box_test-inl.h"
#include "render/accel/leaf_test-inl.h"
#include "render/math/interrupt.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// For solids with many crossings.
std::vector<Crossing>& scratch_of_thread() {
  thread_local std::vector<Crossing> scratch;
  return scratch;
}

HWY_INLINE Ray ray_of(const RayBlock& rays, std::size_t i) { return {rays.origin.vector(i), rays.direction.vector(i)}; }

/// Beyond which crossings count: those that are not before a leaf's box either.
HWY_INLINE double least_depth(double min_depth, double from) {
  return from > min_depth ? std::nextafter(from, 0.0) : min_depth;
}

/// Looks for the nearest crossing of each ray of a block.
///
/// A crossing before the ray enters the leaf's box, or of a leaf whose box it misses, is an artefact of rounding far
/// away from the object; were it taken, the answer could depend on which subtree is visited first.
class ClosestSearch {
 public:
  ClosestSearch(const Leaves& leaves, const RayBlock& rays, FloatRays& float_rays, std::span<Hit> hits)
      : leaves_(leaves), rays_(rays), float_rays_(float_rays), hits_(hits) {}

  /// Begins with the plane that ray i meets first, -1 for none, at `depth`, or else its max_depth.
  HWY_INLINE void begin(std::size_t i, std::int64_t plane, double depth) {
    Hit& hit = hits_[i];
    runner_up_[i] = rays_.max_depth[i];
    if (plane >= 0) {
      const PlaneLeaf& leaf = leaves_.planes[static_cast<std::size_t>(plane)];
      set(hit, depth, 0, {}, leaf.head);
      if (leaf.in_doubt) runner_up_[i] = depth;
    } else {
      hit = Hit();
      hit.depth = depth;
    }
  }

  /// Some beyond the nearest crossing, so that all are met which are in doubt.
  double limit(std::size_t i) const { return hits_[i].depth * (1.0 + TieOrder::kDoubt); }
  /// Whether another solid than that of the nearest crossing was met as near. The same whatever was visited first.
  bool in_doubt(std::size_t i) const { return runner_up_[i] <= limit(i) && runner_up_[i] < rays_.max_depth[i]; }

  /// Ray i meets what `ref` stands for. Pre: it is a leaf.
  HWY_INLINE void visit(std::size_t i, ChildRef ref) {
    if (ref.kind() != ChildKind::sphere) {
      visit_other(i, ref);
      return;
    }
    const SphereBlock& block = leaves_.sphere_blocks[ref.index()];
    alignas(64) double depths[kLanes];
    unsigned bits = meet_spheres(block, rays_, float_rays_, i, limit(i), depths);
    for (bits = seen(block, bits, rays_.hidden_bit[i]); bits != 0; bits &= bits - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(bits));
      offer(i, depths[lane], 0, {}, leaves_.spheres[ref.index() * kLanes + lane], 0.0);
    }
  }

  /// To be called at the end: hits that took part elsewhere are where they are.
  void put_back() {
    for (std::uint64_t bits = early_; bits != 0; bits &= bits - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(bits));
      if (hits_[i].part != kNoIndex && hits_[i].solid == early_solid_[i]) hits_[i].depth = early_depth_[i];
    }
  }

 private:
  bool hidden(std::size_t i, const LeafHead& head) const { return (head.hidden_from & rays_.hidden_bit[i]) != 0; }
  HWY_INLINE ExactRay exact(std::size_t i) const { return ExactRay(rays_, float_rays_.exact_inverse, i); }

  HWY_NOINLINE void visit_other(std::size_t i, ChildRef ref) {
    double from = 0.0;
    if (ref.kind() == ChildKind::box) {
      const BoxLeaf& leaf = leaves_.boxes[ref.index()];
      if (hidden(i, leaf.head) || !exact(i).meets(leaf.bounds, from)) return;
      BoxMet met;
      leaf.box.meet(ray_of(rays_, i), met);
      for (std::size_t m = met.count; m-- > 0;) offer(i, met.depth[m], met.face[m], {}, leaf.head, from);
    } else {
      const SolidLeaf& leaf = leaves_.solids[ref.index()];
      if (leaf.only_blocks || hidden(i, leaf.head) || !exact(i).meets(leaf.bounds, from) || from > limit(i)) return;
      std::vector<Crossing>& scratch = scratch_of_thread();
      scratch.clear();
      const auto hidden_bit = static_cast<std::uint8_t>(rays_.hidden_bit[i]);
      leaf.geometry->nearest(ray_of(rays_, i), hidden_bit, least_depth(rays_.min_depth[i], from), limit(i), scratch);
      LeafHead head = leaf.head;
      if (leaf.is_cramped) return offer_cramped(i, scratch, head, from);
      for (std::size_t c = scratch.size(); c-- > 0;) {
        head.shape = scratch[c].shape;
        head.part = scratch[c].part;
        offer(i, scratch[c].depth, scratch[c].face, scratch[c].place, head, from);
      }
    }
  }

  /// Crossings of one solid are offered last first; the first of equals stays.
  HWY_INLINE void offer(std::size_t i, double depth, std::uint32_t face, const std::array<double, 2>& place,
                        const LeafHead& head, double from) {
    Hit& hit = hits_[i];
    if (!(depth > rays_.min_depth[i] && depth >= from)) return;
    if (!(depth < hit.depth)) {
      if (head.solid != hit.solid) runner_up_[i] = std::min(runner_up_[i], depth);
      return;
    }
    if (head.solid != hit.solid) runner_up_[i] = hit.depth;
    set(hit, depth, face, place, head);
    float_rays_.last[i] = FloatRays::above(depth);
  }

  /// A crossing before the box counts too, but not before the ray has come to the box: it takes part as if it were
  /// there. [POV-Ray 3.7]
  void offer_cramped(std::size_t i, const std::vector<Crossing>& crossings, LeafHead head, double from) {
    const Crossing* nearest = nullptr;
    for (std::size_t c = crossings.size(); c-- > 0;) {
      if (!(crossings[c].depth > rays_.min_depth[i])) continue;
      if (nearest == nullptr || crossings[c].depth < nearest->depth) nearest = &crossings[c];
    }
    if (nearest == nullptr) return;
    head.shape = nearest->shape;
    head.part = nearest->part;
    offer(i, std::max(nearest->depth, from), nearest->face, nearest->place, head, from);
    if (nearest->depth >= from || hits_[i].solid != head.solid) return;
    early_ |= std::uint64_t{1} << i;
    early_solid_[i] = head.solid;
    early_depth_[i] = nearest->depth;
  }

  /// Member by member: a hit that is put together elsewhere and copied is written twice.
  static HWY_INLINE void set(Hit& hit, double depth, std::uint32_t face, const std::array<double, 2>& place,
                             const LeafHead& head) {
    hit.depth = depth;
    hit.shape = head.shape;
    hit.part = head.part;
    hit.face = face;
    hit.place = place;
    hit.solid = head.solid;
  }

  const Leaves& leaves_;
  const RayBlock& rays_;
  FloatRays& float_rays_;
  std::span<Hit> hits_;
  std::uint64_t early_ = 0;  ///< bits of rays that met a cramped solid before its box
  Column<std::uint32_t> early_solid_;
  Column<double> early_depth_;
  Column<double> runner_up_;  ///< the depth of the nearest crossing of another solid than the hit's
};

/// Looks for any opaque crossing of each ray of a block.
class BlockingSearch {
 public:
  BlockingSearch(const Leaves& leaves, const RayBlock& rays, FloatRays& float_rays)
      : leaves_(leaves), rays_(rays), float_rays_(float_rays) {}

  /// Bits of the rays that met something.
  std::uint64_t blocked() const { return blocked_; }
  /// A ray that is blocked looks no further.
  double limit(std::size_t i) const {
    return (blocked_ >> i & 1u) != 0 ? std::numeric_limits<double>::lowest() : rays_.max_depth[i];
  }

  /// Ray i meets what `ref` stands for. Pre: it is a leaf.
  HWY_INLINE void visit(std::size_t i, ChildRef ref) {
    if (ref.kind() != ChildKind::sphere) {
      visit_other(i, ref);
      return;
    }
    const SphereBlock& block = leaves_.sphere_blocks[ref.index()];
    alignas(64) double depths[kLanes];
    unsigned bits = meet_spheres(block, rays_, float_rays_, i, rays_.max_depth[i], depths);
    for (bits = seen(block, bits & block.opaque, rays_.hidden_bit[i]); bits != 0; bits &= bits - 1) {
      offer(i, depths[__builtin_ctz(bits)], 0.0);
    }
  }

 private:
  bool transparent(std::size_t i, const LeafHead& head) const {
    return !head.opaque || (head.hidden_from & rays_.hidden_bit[i]) != 0;
  }
  HWY_INLINE ExactRay exact(std::size_t i) const { return ExactRay(rays_, float_rays_.exact_inverse, i); }

  HWY_NOINLINE void visit_other(std::size_t i, ChildRef ref) {
    if ((blocked_ >> i & 1u) != 0) return;
    double from = 0.0;
    if (ref.kind() == ChildKind::box) {
      const BoxLeaf& leaf = leaves_.boxes[ref.index()];
      if (transparent(i, leaf.head) || !exact(i).meets(leaf.bounds, from)) return;
      BoxMet met;
      leaf.box.meet(ray_of(rays_, i), met);
      for (std::size_t m = 0; m < met.count; ++m) offer(i, met.depth[m], from);
    } else {
      const SolidLeaf& leaf = leaves_.solids[ref.index()];
      if (transparent(i, leaf.head) || !exact(i).meets(leaf.bounds, from) || from > rays_.max_depth[i]) return;
      std::vector<Crossing>& scratch = scratch_of_thread();
      scratch.clear();
      const auto hidden_bit = static_cast<std::uint8_t>(rays_.hidden_bit[i]);
      const double low = least_depth(rays_.min_depth[i], leaf.is_cramped ? 0.0 : from);
      leaf.geometry->nearest(ray_of(rays_, i), hidden_bit, low, rays_.max_depth[i], scratch);
      for (const Crossing& crossing : scratch) {
        if (leaves_.opaque_parts[crossing.part]) offer(i, crossing.depth, leaf.is_cramped ? 0.0 : from);
      }
    }
  }

  HWY_INLINE void offer(std::size_t i, double depth, double from) {
    if (!(depth > rays_.min_depth[i] && depth < rays_.max_depth[i] && depth >= from)) return;
    blocked_ |= std::uint64_t{1} << i;
    float_rays_.last[i] = std::numeric_limits<float>::lowest();
  }

  const Leaves& leaves_;
  const RayBlock& rays_;
  FloatRays& float_rays_;
  std::uint64_t blocked_ = 0;
};

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
using LeafVisits = Visits<kTogether * kTreeWidth>;
/// The pairs taken are opened from the bottom of the stack to its top, so that the nodes on it lie by their depth.
/// Pairs of a depth come only when those of the depth above are taken, which lie below: there are never more of a depth
/// than the children of so many.
using NodeVisits = Visits<kRaysAtOnce + kTogether * kTreeWidth * kTreeDepth>;

/// All rays that may meet something in the tree, through the tree together.
template <class Search>
HWY_INLINE void walk_together(const WideTree& tree, const FloatRays& rays, Search& search) {
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
        const auto is_node = hn::Eq(hn::ShiftRight<30>(refs), hn::Zero(du));
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
    for (std::size_t l = 0; l < leaf_count; ++l) search.visit(leaves.ray[l], ChildRef{leaves.ref[l]});
  }
}

/// For the rare rays that floats do not suit: one alone.
template <class Search>
HWY_NOINLINE void walk_exactly(const WideTree& tree, const ExactRay& ray, std::size_t i, Search& search) {
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
        search.visit(i, ref);
      }
    }
  }
}

/// All rays of the block but those in `done`.
template <class Search>
HWY_INLINE void walk(const Leaves& leaves, const RayBlock& rays, FloatRays& float_rays, std::uint64_t done,
                     Search& search) {
  const std::uint64_t all = rays.all() & ~done;
  if (!leaves.tree.nodes().empty()) {
    float_rays.near &= all;
    walk_together(leaves.tree, float_rays, search);
    for (std::uint64_t bits = all & ~float_rays.usable; bits != 0 && !Interrupt::asked(); bits &= bits - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(bits));
      walk_exactly(leaves.tree, ExactRay(rays, float_rays.exact_inverse, i), i, search);
    }
  }
  for (const ChildRef ref : leaves.beside) {
    if (Interrupt::asked()) return;
    for (std::uint64_t bits = all; bits != 0; bits &= bits - 1) {
      search.visit(static_cast<std::size_t>(__builtin_ctzll(bits)), ref);
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
