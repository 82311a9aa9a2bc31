#include "render/accel/leaves.h"

// This file is compiled once for each instruction set; the best one that the machine has is chosen at run time. What
// differs between them is which children of nodes are visited, never which crossings count.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/accel/traverse.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "render/accel/box_test-inl.h"
#include "render/accel/leaf_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// For solids with many crossings.
std::vector<Crossing>& scratch_of_thread() {
  thread_local std::vector<Crossing> scratch;
  return scratch;
}

/// Looks for the nearest crossing of one ray.
///
/// A crossing before the ray enters the leaf's box, or of a leaf whose box it misses, is an artefact of rounding far
/// away from the object; were it taken, the answer could depend on which subtree is visited first.
class ClosestSearch {
 public:
  /// `plane`: the nearest, met at `depth`; null for none, with `depth` as the query's max_depth.
  ClosestSearch(const Leaves& leaves, const RayQuery& query, const ExactRay& exact, const PlaneLeaf* plane,
                double depth)
      : leaves_(leaves), query_(query), exact_(exact) {
    hit_.depth = depth;
    hit_.solid = 0;  // a crossing at exactly max_depth must not win the tie
    if (plane != nullptr) hit_ = {depth, plane->head.part, 0, plane->head.shape, plane->head.solid};
  }

  double limit() const { return hit_.depth; }
  Hit result() const {
    if (hit_.part == kNoIndex) return Hit();
    return hit_;
  }

  HWY_INLINE void visit(ChildRef ref) {
    if (ref.kind() != ChildKind::sphere) {
      visit_other(ref);
      return;
    }
    SphereCrossings at;
    unsigned bits = meet_spheres(leaves_.sphere_blocks[ref.index()], query_, limit(), at);
    for (; bits != 0; bits &= bits - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(bits));
      const SphereLeaf& leaf = leaves_.spheres[ref.index() * kLanes + lane];
      double from = 0.0;
      if (hidden(leaf.head) || !exact_.meets(leaf.bounds, from)) continue;
      if (sphere_depth_counts(at.leaves[lane])) offer(at.leaves[lane], 0, leaf.head, from);
      if (sphere_depth_counts(at.enters[lane])) offer(at.enters[lane], 0, leaf.head, from);
    }
  }

 private:
  bool hidden(const LeafHead& head) const { return (head.hidden_from & query_.hidden_bit) != 0; }

  HWY_NOINLINE void visit_other(ChildRef ref) {
    double from = 0.0;
    if (ref.kind() == ChildKind::box) {
      const BoxLeaf& leaf = leaves_.boxes[ref.index()];
      if (hidden(leaf.head) || !exact_.meets(leaf.bounds, from)) return;
      Met met;
      leaf.box.meet(query_.ray, met);
      for (std::size_t i = met.count; i-- > 0;) offer(met.depth[i], met.face[i], leaf.head, from);
    } else {
      const SolidLeaf& leaf = leaves_.solids[ref.index()];
      if (hidden(leaf.head) || !exact_.meets(leaf.bounds, from) || from > limit()) return;
      std::vector<Crossing>& scratch = scratch_of_thread();
      scratch.clear();
      leaf.geometry->crossings(query_.ray, query_.hidden_bit, scratch);
      LeafHead head = leaf.head;
      for (std::size_t i = scratch.size(); i-- > 0;) {
        head.shape = scratch[i].shape;
        head.part = scratch[i].part;
        offer(scratch[i].depth, scratch[i].face, head, from);
      }
    }
  }

  /// Crossings of one solid are offered last first; the first of equals stays.
  void offer(double depth, std::uint32_t face, const LeafHead& head, double from) {
    if (!(depth > query_.min_depth && depth >= from)) return;
    if (!(depth < hit_.depth || (depth == hit_.depth && head.solid < hit_.solid))) return;
    hit_ = {depth, head.part, face, head.shape, head.solid};
  }

  const Leaves& leaves_;
  const RayQuery& query_;
  const ExactRay& exact_;
  Hit hit_;
};

/// Looks for any opaque crossing of one ray; the visits tell whether there was one.
class BlockingSearch {
 public:
  BlockingSearch(const Leaves& leaves, const RayQuery& query, const ExactRay& exact)
      : leaves_(leaves), query_(query), exact_(exact) {}

  double limit() const { return query_.max_depth; }

  HWY_INLINE bool visit(ChildRef ref) const {
    if (ref.kind() != ChildKind::sphere) return visit_other(ref);
    SphereCrossings at;
    unsigned bits = meet_spheres(leaves_.sphere_blocks[ref.index()], query_, limit(), at);
    for (; bits != 0; bits &= bits - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(bits));
      const SphereLeaf& leaf = leaves_.spheres[ref.index() * kLanes + lane];
      double from = 0.0;
      if (transparent(leaf.head) || !exact_.meets(leaf.bounds, from)) continue;
      if (sphere_depth_counts(at.leaves[lane]) && blocks(at.leaves[lane], from)) return true;
      if (sphere_depth_counts(at.enters[lane]) && blocks(at.enters[lane], from)) return true;
    }
    return false;
  }

 private:
  bool transparent(const LeafHead& head) const { return !head.opaque || (head.hidden_from & query_.hidden_bit) != 0; }

  HWY_NOINLINE bool visit_other(ChildRef ref) const {
    double from = 0.0;
    if (ref.kind() == ChildKind::box) {
      const BoxLeaf& leaf = leaves_.boxes[ref.index()];
      if (transparent(leaf.head) || !exact_.meets(leaf.bounds, from)) return false;
      Met met;
      leaf.box.meet(query_.ray, met);
      for (std::size_t i = 0; i < met.count; ++i) {
        if (blocks(met.depth[i], from)) return true;
      }
    } else {
      const SolidLeaf& leaf = leaves_.solids[ref.index()];
      if (transparent(leaf.head) || !exact_.meets(leaf.bounds, from) || from > limit()) return false;
      std::vector<Crossing>& scratch = scratch_of_thread();
      scratch.clear();
      leaf.geometry->crossings(query_.ray, query_.hidden_bit, scratch);
      for (const Crossing& crossing : scratch) {
        if (leaves_.opaque_parts[crossing.part] && blocks(crossing.depth, from)) return true;
      }
    }
    return false;
  }
  bool blocks(double depth, double from) const {
    return depth > query_.min_depth && depth < query_.max_depth && depth >= from;
  }

  const Leaves& leaves_;
  const RayQuery& query_;
  const ExactRay& exact_;
};

/// Subtrees still to be visited.
template <class Depth>
class Stack {
 public:
  struct Entry {
    Depth near;
    ChildRef ref;
  };

  bool empty() const { return size_ == 0; }
  Entry pop() { return entries_[--size_]; }
  void push(const Entry& entry) { entries_[size_++] = entry; }
  /// Pushes the children in `bits` so that the nearest comes out first.
  void push_sorted(const WideNode& node, unsigned bits, const Depth* near) {
    const std::size_t bottom = size_;
    for (; bits != 0; bits &= bits - 1) {
      const auto slot = static_cast<std::size_t>(__builtin_ctz(bits));
      const Entry entry{near[slot], node.child[slot]};
      std::size_t at = size_++;
      for (; at > bottom && entries_[at - 1].near < entry.near; --at) entries_[at] = entries_[at - 1];
      entries_[at] = entry;
    }
  }

 private:
  Entry entries_[kTreeDepth * (kTreeWidth - 1) + kTreeWidth];
  std::size_t size_ = 0;
};

/// Nearest first, so that the limit comes down quickly.
template <class BoxRay>
HWY_INLINE void walk(const WideTree& tree, const BoxRay& ray, ClosestSearch& search) {
  using Depth = typename BoxRay::Depth;
  const WideNode* nodes = tree.nodes().data();
  Depth last = BoxRay::above(search.limit());
  Stack<Depth> stack;
  stack.push({std::numeric_limits<Depth>::lowest(), ChildRef::of(ChildKind::node, 0)});
  while (!stack.empty()) {
    const auto entry = stack.pop();
    if (entry.near > last) continue;
    ChildRef ref = entry.ref;
    while (ref.kind() == ChildKind::node) {
      const WideNode& node = nodes[ref.index()];
      alignas(64) Depth near[kTreeWidth];
      const unsigned bits = ray.meet_children(node, last, near);
      if ((bits & (bits - 1)) == 0) {
        if (bits == 0) break;
        ref = node.child[__builtin_ctz(bits)];
      } else {
        stack.push_sorted(node, bits, near);
        ref = stack.pop().ref;
      }
    }
    if (ref.kind() != ChildKind::node) {
      search.visit(ref);
      last = BoxRay::above(search.limit());
    }
  }
}

/// Whether anything blocks; leaves are asked at once, as any answer ends the search.
template <class BoxRay>
HWY_INLINE bool walk(const WideTree& tree, const BoxRay& ray, const BlockingSearch& search) {
  const WideNode* nodes = tree.nodes().data();
  std::uint32_t stack[kTreeDepth * (kTreeWidth - 1) + kTreeWidth];
  std::size_t size = 0;
  const auto last = BoxRay::above(search.limit());
  stack[size++] = 0;
  while (size != 0) {
    const WideNode& node = nodes[stack[--size]];
    alignas(64) typename BoxRay::Depth near[kTreeWidth];
    for (unsigned bits = ray.meet_children(node, last, near); bits != 0; bits &= bits - 1) {
      const ChildRef ref = node.child[__builtin_ctz(bits)];
      if (ref.kind() == ChildKind::node) {
        stack[size++] = ref.index();
      } else if (search.visit(ref)) {
        return true;
      }
    }
  }
  return false;
}

/// For the rare rays that floats do not suit; kept out of the way of the others.
HWY_NOINLINE void walk_exactly(const WideTree& tree, const ExactRay& ray, ClosestSearch& search) {
  walk(tree, ray, search);
}
HWY_NOINLINE bool walk_exactly(const WideTree& tree, const ExactRay& ray, const BlockingSearch& search) {
  return walk(tree, ray, search);
}

HWY_INLINE RayQuery query_of(const RayBlock& rays, std::size_t i) {
  return {{rays.origin.vector(i), rays.direction.vector(i)},
          rays.min_depth[i],
          rays.max_depth[i],
          static_cast<std::uint8_t>(rays.hidden_bit[i])};
}

void closest_of_block(const Leaves& leaves, const RayBlock& rays, std::span<Hit> hits) {
  PlaneHits planes;
  meet_planes(leaves.planes, rays, planes);
  const FloatRays float_rays(rays, planes.depth, leaves.tree);
  const bool has_tree = !leaves.tree.nodes().empty();
  for (std::size_t i = 0; i < rays.size; ++i) {
    const RayQuery query = query_of(rays, i);
    const PlaneLeaf* plane = planes.plane[i] >= 0 ? &leaves.planes[static_cast<std::size_t>(planes.plane[i])] : nullptr;
    const ExactRay exact(rays, float_rays.exact_inverse, i);
    ClosestSearch search(leaves, query, exact, plane, planes.depth[i]);
    for (const ChildRef ref : leaves.beside) search.visit(ref);
    if (has_tree) {
      if ((float_rays.near >> i & 1u) != 0) {
        walk(leaves.tree, FloatRay(float_rays, i), search);
      } else if ((float_rays.usable >> i & 1u) == 0) {
        walk_exactly(leaves.tree, exact, search);
      }
    }
    hits[i] = search.result();
  }
}

std::uint64_t occluded_of_block(const Leaves& leaves, const RayBlock& rays) {
  std::uint64_t blocked = blocked_by_planes(leaves.planes, rays);
  const FloatRays float_rays(rays, rays.max_depth, leaves.tree);
  const std::uint64_t all = ~std::uint64_t{0} >> (kRaysAtOnce - rays.size);
  std::uint64_t open = all & ~blocked;
  if (leaves.tree.nodes().empty()) open = 0;
  for (std::uint64_t left = open & (float_rays.near | ~float_rays.usable); left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
    const RayQuery query = query_of(rays, i);
    const ExactRay exact(rays, float_rays.exact_inverse, i);
    const BlockingSearch search(leaves, query, exact);
    const bool is_blocked = (float_rays.near >> i & 1u) != 0 ? walk(leaves.tree, FloatRay(float_rays, i), search)
                                                             : walk_exactly(leaves.tree, exact, search);
    blocked |= std::uint64_t{is_blocked} << i;
  }
  if (leaves.beside.empty()) return blocked;
  for (std::uint64_t left = all & ~blocked; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
    const RayQuery query = query_of(rays, i);
    const ExactRay exact(rays, float_rays.exact_inverse, i);
    const BlockingSearch search(leaves, query, exact);
    const bool is_blocked =
        std::any_of(leaves.beside.begin(), leaves.beside.end(), [&](ChildRef ref) { return search.visit(ref); });
    blocked |= std::uint64_t{is_blocked} << i;
  }
  return blocked;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(closest_of_block);
HWY_EXPORT(occluded_of_block);

void find_closest(const Leaves& leaves, const RayBlock& rays, std::span<Hit> hits) {
  HWY_DYNAMIC_DISPATCH(closest_of_block)(leaves, rays, hits);
}

std::uint64_t find_occluded(const Leaves& leaves, const RayBlock& rays) {
  return HWY_DYNAMIC_DISPATCH(occluded_of_block)(leaves, rays);
}

}  // namespace firstlight::render
#endif
