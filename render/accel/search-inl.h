// Searches among the leaves: for the nearest crossing, or for any opaque one. A search says which leaves it sees and
// takes what they offer; how a leaf is met is its kind's own affair.
// Included once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_ACCEL_SEARCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_ACCEL_SEARCH_INL_H
#undef FIRSTLIGHT_RENDER_ACCEL_SEARCH_INL_H
#else
#define FIRSTLIGHT_RENDER_ACCEL_SEARCH_INL_H
#endif

#include "render/accel/box_test-inl.h"
#include "render/accel/leaf/box-inl.h"
#include "render/accel/leaf/plane-inl.h"
#include "render/accel/leaf/solid-inl.h"
#include "render/accel/leaf/sphere-inl.h"
#include "render/accel/leaf_groups.h"
#include "render/accel/leaves.h"
#include "render/math/interrupt.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// The part that both searches share.
class BlockSearch {
 public:
  BlockSearch(const Leaves& leaves, const RayBlock& rays, FloatRays& float_rays)
      : leaves_(leaves), rays_(rays), float_rays_(float_rays) {}

  const Leaves& leaves() const { return leaves_; }
  const RayBlock& rays() const { return rays_; }
  const FloatRays& float_rays() const { return float_rays_; }
  HWY_INLINE ExactRay exact(std::size_t i) const { return ExactRay(rays_, float_rays_.exact_inverse, i); }
  HWY_INLINE Ray ray(std::size_t i) const { return rays_.ray(i); }
  /// Up to which depth crossings of each ray matter.
  const Column<double>& limits() const { return limits_; }
  double limit(std::size_t i) const { return limits_[i]; }

 protected:
  /// The bits of those rays in `who` that see what is hidden from kinds with these bits.
  std::uint64_t without_hidden(std::uint64_t who, std::uint8_t hidden_from) const {
    if (hidden_from == 0) return who;
    std::uint64_t seeing = 0;
    for (std::uint64_t bits = who; bits != 0; bits &= bits - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(bits));
      if ((hidden_from & rays_.hidden_bit[i]) == 0) seeing |= std::uint64_t{1} << i;
    }
    return seeing;
  }

  Column<double> limits_;
  const Leaves& leaves_;
  const RayBlock& rays_;
  FloatRays& float_rays_;
};

/// Looks for the nearest crossing of each ray of a block.
///
/// A crossing before the ray enters the leaf's box, or of a leaf whose box it misses, is an artefact of rounding far
/// away from the object; were it taken, the answer could depend on which subtree is visited first.
class ClosestSearch : public BlockSearch {
 public:
  ClosestSearch(const Leaves& leaves, const RayBlock& rays, FloatRays& float_rays, std::span<Hit> hits)
      : BlockSearch(leaves, rays, float_rays), hits_(hits) {}

  /// Begins with the plane that ray i meets first, -1 for none, at `depth`, or else its max_depth.
  HWY_INLINE void begin(std::size_t i, std::int64_t plane, double depth) {
    Hit& hit = hits_[i];
    runner_up_[i] = rays_.max_depth[i];
    limit_at(i, depth);
    if (plane >= 0) {
      const PlaneLeaf& leaf = leaves_.planes[static_cast<std::size_t>(plane)];
      set(hit, depth, 0, {}, leaf.head);
      if (leaf.in_doubt) runner_up_[i] = depth;
    } else {
      hit = Hit();
      hit.depth = depth;
    }
  }

  /// Whether another solid than that of the nearest crossing was met as near. The same whatever was visited first.
  bool in_doubt(std::size_t i) const { return runner_up_[i] <= limit(i) && runner_up_[i] < rays_.max_depth[i]; }

  /// To be called at the end: hits that took part elsewhere are where they are.
  void put_back() {
    for (std::uint64_t bits = early_; bits != 0; bits &= bits - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(bits));
      if (hits_[i].part != kNoIndex && hits_[i].solid == early_solid_[i]) hits_[i].depth = early_depth_[i];
    }
  }

  static constexpr bool kAsksForOpaque = false;
  /// Returns those of the rays in `who` that see the leaf.
  std::uint64_t seeing(std::uint64_t who, const LeafHead& head) const { return without_hidden(who, head.hidden_from); }

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
    limit_at(i, depth);
    float_rays_.last[i] = FloatRays::above(depth);
  }

  /// Offers the nearest crossing of one solid: beyond min_depth and, unless the solid is cramped, not before `from`.
  HWY_INLINE void offer_nearest(std::size_t i, double depth, const Slot& slot, const SolidLeaf& leaf, double from) {
    LeafHead head = leaf.head;
    head.shape = slot.shape;
    head.part = slot.part;
    if (leaf.is_cramped) return offer_nearest_cramped(i, depth, slot.face_of(i), slot.place_of(i), head, from);
    offer(i, depth, slot.face_of(i), slot.place_of(i), head, from);
  }
  /// Offers the crossings of one solid.
  HWY_INLINE void offer_all(std::size_t i, const std::vector<Crossing>& crossings, const SolidLeaf& leaf, double from) {
    LeafHead head = leaf.head;
    if (leaf.is_cramped) return offer_cramped(i, crossings, head, from);
    for (std::size_t c = crossings.size(); c-- > 0;) {
      head.shape = crossings[c].shape;
      head.part = crossings[c].part;
      offer(i, crossings[c].depth, crossings[c].face, crossings[c].place, head, from);
    }
  }

 private:
  /// Some beyond the nearest crossing, so that all are met which are in doubt.
  HWY_INLINE void limit_at(std::size_t i, double depth) { limits_[i] = depth * (1.0 + TieOrder::kDoubt); }

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
    offer_nearest_cramped(i, nearest->depth, nearest->face, nearest->place, head, from);
  }
  void offer_nearest_cramped(std::size_t i, double depth, std::uint32_t face, const std::array<double, 2>& place,
                             const LeafHead& head, double from) {
    offer(i, std::max(depth, from), face, place, head, from);
    if (depth >= from || hits_[i].solid != head.solid) return;
    early_ |= std::uint64_t{1} << i;
    early_solid_[i] = head.solid;
    early_depth_[i] = depth;
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

  std::span<Hit> hits_;
  std::uint64_t early_ = 0;  ///< bits of rays that met a cramped solid before its box
  Column<std::uint32_t> early_solid_;
  Column<double> early_depth_;
  Column<double> runner_up_;  ///< the depth of the nearest crossing of another solid than the hit's
};

/// Looks for any opaque crossing of each ray of a block.
class BlockingSearch : public BlockSearch {
 public:
  BlockingSearch(const Leaves& leaves, const RayBlock& rays, FloatRays& float_rays)
      : BlockSearch(leaves, rays, float_rays) {
    limits_ = rays.max_depth;
  }

  static constexpr bool kAsksForOpaque = true;
  /// Returns those of the rays in `who` that see the leaf and are not blocked.
  std::uint64_t seeing(std::uint64_t who, const LeafHead& head) const {
    return head.opaque ? without_hidden(who & ~blocked_, head.hidden_from) : 0;
  }

  /// Bits of the rays that met something.
  std::uint64_t blocked() const { return blocked_; }

  HWY_INLINE void offer(std::size_t i, double depth, std::uint32_t, const std::array<double, 2>&, const LeafHead&,
                        double from) {
    if (!(depth > rays_.min_depth[i] && depth < rays_.max_depth[i] && depth >= from)) return;
    blocked_ |= std::uint64_t{1} << i;
    limits_[i] = std::numeric_limits<double>::lowest();  // it looks no further
    float_rays_.last[i] = std::numeric_limits<float>::lowest();
  }
  /// Offers something opaque of one solid that counts.
  HWY_INLINE void offer_nearest(std::size_t i, double depth, const Slot& slot, const SolidLeaf& leaf, double from) {
    LeafHead head = leaf.head;
    head.part = slot.part;
    offer(i, depth, 0, {}, head, leaf.is_cramped ? 0.0 : from);
  }
  /// Offers the crossings of one solid.
  HWY_INLINE void offer_all(std::size_t i, const std::vector<Crossing>& crossings, const SolidLeaf& leaf, double from) {
    for (const Crossing& crossing : crossings) {
      if (!leaves_.opaque_parts[crossing.part]) continue;
      offer(i, crossing.depth, 0, {}, leaf.head, leaf.is_cramped ? 0.0 : from);
    }
  }

 private:
  std::uint64_t blocked_ = 0;
};

/// Rays meet what `ref` stands for together. Pre: neither a node nor spheres.
template <class Search>
HWY_NOINLINE void meet_together(const Leaves& leaves, std::uint64_t who, ChildRef ref, Search& search) {
  switch (ref.kind()) {
    case ChildKind::box:
      return meet_leaf(leaves.boxes[ref.index()], who, search);
    default:
      return meet_leaf(leaves.solids[ref.index()], who, search);
  }
}

/// All that wait meet their leaves.
template <class Search>
HWY_NOINLINE void meet_waiting(LeafGroups& waiting, Search& search) {
  const Leaves& leaves = search.leaves();
  waiting.sort([&](ChildRef ref, std::size_t ray) {
    double near = 0.0;
    search.exact(ray).meets(leaves.bounds(ref), near);
    return near;
  });
  for (const ChildRef ref : waiting.leaves()) {
    if (Interrupt::asked()) break;
    meet_together(leaves, waiting.take(ref), ref, search);
  }
  waiting.clear();
}

/// A ray comes to what `ref` stands for: spheres are met at once, other leaves wait for more rays. Pre: it is a leaf.
template <class Search>
HWY_INLINE void visit(const Leaves& leaves, std::size_t ray, ChildRef ref, LeafGroups& waiting, Search& search) {
  if (ref.kind() != ChildKind::sphere) return waiting.add(ref, ray);
  const std::size_t block = ref.index();
  meet_leaf(leaves.sphere_blocks[block], leaves.spheres.data() + block * kLanes, ray, search);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
