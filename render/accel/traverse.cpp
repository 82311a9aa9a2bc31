#include "render/accel/leaves.h"

// This file is compiled once for each instruction set; the best one that the machine has is chosen at run time. Only
// the box tests use vectors, and they round alike for every width, so the answers do not depend on the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/accel/traverse.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A ray prepared for box tests.
struct BoxRay {
  double origin[3];
  double inverse[3];
  int near_row[3];  ///< row of WideNode::bounds where the ray enters, by axis; the other row of the pair is the exit
  double min_depth;

  explicit BoxRay(const RayQuery& query) : min_depth(query.min_depth) {
    // A direction of zero becomes one of almost zero: the products below stay numbers, and a ray in the plane of a
    // face is decided by which side of the face it lies on.
    constexpr double kAlmostZero = 1e-300;
    for (int axis = 0; axis < 3; ++axis) {
      double d = query.ray.direction[axis];
      if (std::abs(d) < kAlmostZero) d = std::copysign(kAlmostZero, d);
      origin[axis] = query.ray.origin[axis];
      inverse[axis] = 1.0 / d;
      near_row[axis] = 2 * axis + (d < 0.0 ? 1 : 0);
    }
  }
};

/// Bits of the slots that the ray meets between its min_depth and `max_depth`; `near` gets where it enters them.
///
/// A slab's depth (face - origin) / direction is computed with three roundings; the exit is moved away by more than
/// twice that, so no box that the exact ray meets is missed. [Ize, Robust BVH Ray Traversal, 2013]
/// Each operation is monotone: a box within another is never entered before it, nor left after it.
HWY_INLINE unsigned meet_boxes(const WideNode& node, const BoxRay& ray, double max_depth, double* HWY_RESTRICT near) {
  const hn::CappedTag<double, kTreeWidth> wide;
  const hn::Rebind<float, decltype(wide)> narrow;
  constexpr double kAway = 1.0 + 2e-15;
  const auto min_depth = hn::Set(wide, ray.min_depth);
  const auto last = hn::Set(wide, max_depth);
  const auto away = hn::Set(wide, kAway);
  unsigned bits = 0;
  for (std::size_t slot = 0; slot < kTreeWidth; slot += hn::Lanes(wide)) {
    auto enter = min_depth;
    auto leave = hn::Set(wide, 1e308);
    for (int axis = 0; axis < 3; ++axis) {
      const auto origin = hn::Set(wide, ray.origin[axis]);
      const auto inverse = hn::Set(wide, ray.inverse[axis]);
      const int row = ray.near_row[axis];
      const auto near_face = hn::PromoteTo(wide, hn::Load(narrow, node.bounds[row] + slot));
      const auto far_face = hn::PromoteTo(wide, hn::Load(narrow, node.bounds[row ^ 1] + slot));
      enter = hn::Max(enter, hn::Mul(hn::Sub(near_face, origin), inverse));
      leave = hn::Min(leave, hn::Mul(hn::Sub(far_face, origin), inverse));
    }
    leave = hn::Min(hn::Mul(leave, away), last);
    std::uint8_t byte[8] = {};
    hn::StoreMaskBits(wide, hn::Le(enter, leave), byte);
    bits |= static_cast<unsigned>(byte[0]) << slot;
    hn::Store(enter, wide, near + slot);
  }
  return bits;
}

/// Subtrees still to be visited, nearest on top.
class Stack {
 public:
  struct Entry {
    double near;
    ChildRef ref;
  };

  bool empty() const { return size_ == 0; }
  Entry pop() { return entries_[--size_]; }
  void push(const Entry& entry) { entries_[size_++] = entry; }
  /// Pushes the children in `bits` so that the nearest comes out first.
  void push_sorted(const WideNode& node, unsigned bits, const double* near) {
    const std::size_t bottom = size_;
    for (; bits != 0; bits &= bits - 1) {
      const auto slot = static_cast<std::size_t>(__builtin_ctz(bits));
      const Entry entry{near[slot], node.child[slot]};
      std::size_t at = size_++;
      for (; at > bottom && entries_[at - 1].near < entry.near; --at) entries_[at] = entries_[at - 1];
      entries_[at] = entry;
    }
  }
  void push_unsorted(const WideNode& node, unsigned bits, const double* near) {
    for (; bits != 0; bits &= bits - 1) {
      const auto slot = static_cast<std::size_t>(__builtin_ctz(bits));
      push({near[slot], node.child[slot]});
    }
  }

 private:
  Entry entries_[kTreeDepth * (kTreeWidth - 1) + kTreeWidth];
  std::size_t size_ = 0;
};

/// Looks for the nearest crossing of one ray.
///
/// `from` is where the ray enters the leaf's box. A crossing before it is an artefact of rounding far away from the
/// object; were it taken, the answer could depend on which subtree is visited first.
class ClosestSearch {
 public:
  ClosestSearch(const Leaves& leaves, const RayQuery& query, std::vector<Crossing>& scratch)
      : leaves_(leaves), query_(query), scratch_(scratch) {
    hit_.depth = query.max_depth;
    hit_.solid = 0;  // a crossing at exactly max_depth must not win the tie
  }

  double limit() const { return hit_.depth; }
  bool done() const { return false; }
  Hit result() const {
    if (hit_.part == kNoIndex) return Hit();
    return hit_;
  }

  void visit(const SphereLeaf& leaf, double from) {
    if (hidden(leaf.head)) return;
    double enters;
    double leaves;
    if (!meet_sphere(query_.ray, leaf.center, leaf.radius_squared, enters, leaves)) return;
    if (sphere_depth_counts(leaves)) offer(leaves, 0, leaf.head, from);
    if (sphere_depth_counts(enters)) offer(enters, 0, leaf.head, from);
  }
  void visit(const BoxLeaf& leaf, double from) {
    if (hidden(leaf.head)) return;
    Met met;
    leaf.box.meet(query_.ray, met);
    for (std::size_t i = met.count; i-- > 0;) offer(met.depth[i], met.face[i], leaf.head, from);
  }
  void visit(const PlaneLeaf& leaf) {
    if (hidden(leaf.head)) return;
    const double depth = leaf.plane->meet(query_.ray);
    if (depth > 0.0) offer(depth, 0, leaf.head, 0.0);
  }
  void visit(const SolidLeaf& leaf, double from) {
    if (hidden(leaf.head)) return;
    scratch_.clear();
    leaf.geometry->crossings(query_.ray, query_.hidden_bit, scratch_);
    LeafHead head = leaf.head;
    for (std::size_t i = scratch_.size(); i-- > 0;) {
      head.shape = scratch_[i].shape;
      head.part = scratch_[i].part;
      offer(scratch_[i].depth, scratch_[i].face, head, from);
    }
  }

 private:
  bool hidden(const LeafHead& head) const { return (head.hidden_from & query_.hidden_bit) != 0; }

  /// Crossings of one solid are offered last first; the first of equals stays.
  void offer(double depth, std::uint32_t face, const LeafHead& head, double from) {
    if (!(depth > query_.min_depth && depth >= from)) return;
    if (!(depth < hit_.depth || (depth == hit_.depth && head.solid < hit_.solid))) return;
    hit_ = {depth, head.part, face, head.shape, head.solid};
  }

  const Leaves& leaves_;
  const RayQuery& query_;
  std::vector<Crossing>& scratch_;
  Hit hit_;
};

/// Looks for any opaque crossing of one ray.
class BlockingSearch {
 public:
  BlockingSearch(const Leaves& leaves, const RayQuery& query, std::vector<Crossing>& scratch)
      : leaves_(leaves), query_(query), scratch_(scratch) {}

  double limit() const { return query_.max_depth; }
  bool done() const { return blocked_; }
  bool result() const { return blocked_; }

  void visit(const SphereLeaf& leaf, double from) {
    if (transparent(leaf.head)) return;
    double enters;
    double leaves;
    if (!meet_sphere(query_.ray, leaf.center, leaf.radius_squared, enters, leaves)) return;
    if (sphere_depth_counts(enters)) offer(enters, from);
    if (sphere_depth_counts(leaves)) offer(leaves, from);
  }
  void visit(const BoxLeaf& leaf, double from) {
    if (transparent(leaf.head)) return;
    Met met;
    leaf.box.meet(query_.ray, met);
    for (std::size_t i = 0; i < met.count; ++i) offer(met.depth[i], from);
  }
  void visit(const PlaneLeaf& leaf) {
    if (transparent(leaf.head)) return;
    const double depth = leaf.plane->meet(query_.ray);
    if (depth > 0.0) offer(depth, 0.0);
  }
  void visit(const SolidLeaf& leaf, double from) {
    if (transparent(leaf.head)) return;
    scratch_.clear();
    leaf.geometry->crossings(query_.ray, query_.hidden_bit, scratch_);
    for (const Crossing& crossing : scratch_) {
      if (leaves_.opaque_parts[crossing.part]) offer(crossing.depth, from);
    }
  }

 private:
  bool transparent(const LeafHead& head) const { return !head.opaque || (head.hidden_from & query_.hidden_bit) != 0; }
  void offer(double depth, double from) {
    if (depth > query_.min_depth && depth < query_.max_depth && depth >= from) blocked_ = true;
  }

  const Leaves& leaves_;
  const RayQuery& query_;
  std::vector<Crossing>& scratch_;
  bool blocked_ = false;
};

template <class Search>
HWY_INLINE void visit_leaf(const Leaves& leaves, ChildRef ref, double from, Search& search) {
  if (ref.kind() == ChildKind::sphere) {
    search.visit(leaves.spheres[ref.index()], from);
  } else if (ref.kind() == ChildKind::box) {
    search.visit(leaves.boxes[ref.index()], from);
  } else {
    search.visit(leaves.solids[ref.index()], from);
  }
}

template <bool kSorted, class Search>
HWY_INLINE void walk(const Leaves& leaves, const RayQuery& query, Search& search) {
  for (const PlaneLeaf& plane : leaves.planes) search.visit(plane);
  for (const ChildRef ref : leaves.beside) visit_leaf(leaves, ref, 0.0, search);
  if (leaves.tree.nodes().empty()) return;

  const BoxRay ray(query);
  const WideNode* nodes = leaves.tree.nodes().data();
  Stack stack;
  stack.push({query.min_depth, ChildRef::of(ChildKind::node, 0)});
  while (!stack.empty() && !search.done()) {
    const Stack::Entry entry = stack.pop();
    if (entry.near > search.limit()) continue;
    if (entry.ref.kind() != ChildKind::node) {
      visit_leaf(leaves, entry.ref, entry.near, search);
      continue;
    }
    const WideNode& node = nodes[entry.ref.index()];
    alignas(64) double near[kTreeWidth];
    const unsigned bits = meet_boxes(node, ray, search.limit(), near);
    if constexpr (kSorted) {
      stack.push_sorted(node, bits, near);
    } else {
      stack.push_unsorted(node, bits, near);
    }
  }
}

thread_local std::vector<Crossing> scratch_of_thread;

void closest_of_block(const Leaves& leaves, std::span<const RayQuery> queries, std::span<Hit> hits) {
  std::vector<Crossing>& scratch = scratch_of_thread;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    ClosestSearch search(leaves, queries[i], scratch);
    walk<true>(leaves, queries[i], search);
    hits[i] = search.result();
  }
}

void occluded_of_block(const Leaves& leaves, std::span<const RayQuery> queries, std::span<std::uint8_t> blocked) {
  std::vector<Crossing>& scratch = scratch_of_thread;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    BlockingSearch search(leaves, queries[i], scratch);
    walk<false>(leaves, queries[i], search);
    blocked[i] = search.result() ? 1 : 0;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(closest_of_block);
HWY_EXPORT(occluded_of_block);

void find_closest(const Leaves& leaves, std::span<const RayQuery> queries, std::span<Hit> hits) {
  HWY_DYNAMIC_DISPATCH(closest_of_block)(leaves, queries, hits);
}

void find_occluded(const Leaves& leaves, std::span<const RayQuery> queries, std::span<std::uint8_t> blocked) {
  HWY_DYNAMIC_DISPATCH(occluded_of_block)(leaves, queries, blocked);
}

}  // namespace firstlight::render
#endif
