// How rays go through a RayTree. Included once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_MATH_RAY_TREE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_MATH_RAY_TREE_INL_H
#undef FIRSTLIGHT_RENDER_MATH_RAY_TREE_INL_H
#else
#define FIRSTLIGHT_RENDER_MATH_RAY_TREE_INL_H
#endif

#include "render/lanes/lanes-inl.h"
#include "render/math/ray_columns.h"
#include "render/math/ray_tree.h"

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Asks for memory that will be read soon.
template <class T>
HWY_INLINE void fetch_ahead(const T& next) {
  for (std::size_t at = 0; at < sizeof(T); at += 64) __builtin_prefetch(reinterpret_cast<const char*>(&next) + at);
}

/// The rays of a block on their way through a tree together. A node is opened once for all that come to it, and tests all
/// its children against one ray after the other.
///
/// Boxes are tested in float, beside the tree's middle and from where the ray comes to the tree: there all numbers are
/// within its reach R. With u = 2^-24 the origin is off by R u, its difference to a face by 2 R u, less than the room that
/// boxes have; the direction's inverse and the product make depths off by 3 u of themselves, less than kAway allows. From
/// farther away than 2^28 R no ray is told from its neighbours in double either.
class TreeWalk {
 public:
  TreeWalk(const RayTree& tree, const RayColumns& rays) : tree_(tree), rays_(rays) {}

  /// Ray i, in `who`, looks up to high[i]. Calls meet_leaf(number, rays) for the leaves that rays come to, the nearer ones
  /// first as far as the rays agree.
  template <class MeetLeaf, class FetchLeaf>
  HWY_INLINE void walk(std::uint64_t who, const Column<double>& high, const MeetLeaf& meet_leaf,
                       const FetchLeaf& fetch_leaf) {
    if (tree_.nodes().empty()) return;
    who = begin(who, high);
    while (who != 0) {
      const unsigned octant = octant_of(static_cast<std::size_t>(__builtin_ctzll(who)));
      std::uint64_t alike = who;
      for (std::size_t axis = 0; axis < 3; ++axis) alike &= (octant >> axis & 1) != 0 ? down_[axis] : ~down_[axis];
      who &= ~alike;
      walk_alike(octant, alike, meet_leaf, fetch_leaf);
    }
  }

  /// Ray i looks no farther any more.
  HWY_INLINE void look_up_to(std::size_t i, double high) {
    limit_[i] = static_cast<float>(((high - begin_[i]) + begin_[i] * kFar) * kAway);
  }

 private:
  using Floats = hn::CappedTag<float, RayTree::kWidth>;
  struct Waiting {
    std::uint64_t rays;
    RayTree::Child child;
    float near;  ///< the least depth at which one of them comes to it
  };

  unsigned octant_of(std::size_t i) const {
    return static_cast<unsigned>(down_[0] >> i & 1) | static_cast<unsigned>(down_[1] >> i & 1) << 1 |
           static_cast<unsigned>(down_[2] >> i & 1) << 2;
  }
  /// Rays of one octant.
  template <class MeetLeaf, class FetchLeaf>
  HWY_INLINE void walk_alike(unsigned octant, std::uint64_t who, const MeetLeaf& meet_leaf,
                             const FetchLeaf& fetch_leaf) {
    size_ = 0;
    waiting_[size_++] = {who, RayTree::Child::node(0), 0.0f};
    while (size_ != 0) {
      const Waiting next = waiting_[--size_];
      const std::uint64_t left = looking_up_to(next.near, next.rays);
      if (left == 0) continue;
      if (next.child.is_leaf()) {
        meet_leaf(next.child.number(), left);
      } else {
        open(tree_.nodes()[next.child.number()], octant, left, fetch_leaf);
      }
    }
  }

  /// Returns the rays that meet the box of all.
  HWY_INLINE std::uint64_t begin(std::uint64_t who, const Column<double>& high) {
    const hn::Rebind<float, LaneTag> narrow;
    const auto rounded = [&](const Lanes& a, Column<float>& to, std::size_t i)
                             HWY_ATTR { hn::StoreU(hn::DemoteTo(narrow, a.v), narrow, &to[i]); };
    std::uint64_t coming = 0;
    down_[0] = down_[1] = down_[2] = 0;
    for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
      const std::uint64_t of_vector = who >> i & kAllLanes;
      if (of_vector == 0) continue;
      const Lanes limit = load<Lanes>(high, i);
      Lanes begin = 0.0, leaves = limit;
      Lanes inverse[3];
      for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const Lanes d = load<Lanes>(rays_.direction.of[a], i);
        inverse[a] = 1.0 / copysign(clamp(abs(d), kLeast, 1.0 / kLeast), d);
        down_[a] |= std::uint64_t{bits(inverse[a] < 0.0)} << i;
        const Lanes to_middle = (tree_.middle()[axis] - load<Lanes>(rays_.origin.of[a], i)) * inverse[a];
        const Lanes half = tree_.reach()[axis] * abs(inverse[a]);
        begin = max(begin, to_middle - half);
        leaves = min(leaves, to_middle + half);
      }
      for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const Lanes beside = load<Lanes>(rays_.origin.of[a], i) + begin * load<Lanes>(rays_.direction.of[a], i);
        rounded(beside - tree_.middle()[axis], origin_.of[a], i);
        rounded(inverse[a], inverse_.of[a], i);
      }
      store(begin, begin_, i);
      rounded(((limit - begin) + begin * kFar) * kAway, limit_, i);
      coming |= (bits(begin <= leaves * kAway) & of_vector) << i;
    }
    return coming;
  }

  /// Bits of those of the rays that look up to that depth.
  HWY_INLINE std::uint64_t looking_up_to(float depth, std::uint64_t rays) const {
    const Floats d;
    if (is_one(rays)) return limit_[static_cast<std::size_t>(__builtin_ctzll(rays))] >= depth ? rays : 0;
    std::uint64_t looking = 0;
    for (std::size_t i = 0; i < kRaysAtOnce; i += hn::Lanes(d)) {
      looking |= bits_of(hn::Ge(hn::LoadU(d, &limit_[i]), hn::Set(d, depth))) << i;
    }
    return looking & rays;
  }
  static bool is_one(std::uint64_t rays) { return (rays & (rays - 1)) == 0; }
  template <class Mask>
  static HWY_INLINE std::uint64_t bits_of(const Mask& mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Floats(), mask, bytes);
    return bytes[0];
  }

  /// The children that rays meet wait, the nearest on top.
  template <class FetchLeaf>
  HWY_INLINE void open(const RayTree::Node& node, unsigned octant, std::uint64_t who, const FetchLeaf& fetch_leaf) {
    float near[RayTree::kWidth];
    unsigned met = 0;
    for (std::size_t i = 0; i < RayTree::kWidth; i += hn::Lanes(Floats())) {
      met |= meet_children(node, i, octant, who, near);
    }
    for (std::size_t n = node.count(); n-- > 0;) {
      const std::size_t child = node.nth(octant, n);
      if ((met >> child & 1) == 0) continue;
      waiting_[size_++] = {rays_that_met(child, who), node.child[child], near[child]};
      const RayTree::Child next = node.child[child];
      if (next.is_leaf()) {
        fetch_leaf(next.number());
      } else {
        fetch_ahead(tree_.nodes()[next.number()]);
      }
    }
  }

  /// Tests as many children from `first` on as floats are in a vector; returns the bits of those that are met, and where
  /// rays come to each. Those that are not there may be met.
  HWY_INLINE unsigned meet_children(const RayTree::Node& node, std::size_t first, unsigned octant, std::uint64_t who,
                                    float* near) {
    const Floats d;
    const auto infinite = hn::Set(d, std::numeric_limits<float>::infinity());
    auto nearest = infinite;
    const std::size_t row_x = octant & 1, row_y = 2 + (octant >> 1 & 1), row_z = 4 + (octant >> 2);
    const auto face = [&](std::size_t row) HWY_ATTR { return hn::Load(d, node.bounds[row] + first); };
    const auto near_x = face(row_x), near_y = face(row_y), near_z = face(row_z);
    const auto far_x = face(row_x ^ 1), far_y = face(row_y ^ 1), far_z = face(row_z ^ 1);
    unsigned any = 0;
    for (; who != 0; who &= who - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(who));
      auto enters = hn::Zero(d), leaves = hn::Set(d, limit_[i]);
      const auto pass = [&](const auto& near_face, const auto& far_face, std::size_t axis) HWY_ATTR {
        const auto origin = hn::Set(d, origin_.of[axis][i]), inverse = hn::Set(d, inverse_.of[axis][i]);
        enters = hn::Max(enters, hn::Mul(hn::Sub(near_face, origin), inverse));
        leaves = hn::Min(leaves, hn::Mul(hn::Sub(far_face, origin), inverse));
      };
      pass(near_x, far_x, 0);
      pass(near_y, far_y, 1);
      pass(near_z, far_z, 2);
      const auto met = hn::Le(enters, hn::Mul(leaves, hn::Set(d, kAway)));
      nearest = hn::Min(nearest, hn::IfThenElse(met, enters, infinite));
      const auto children = static_cast<unsigned>(bits_of(met) << first);
      any |= children;
      met_[i] = static_cast<std::uint8_t>(first == 0 ? children : met_[i] | children);
    }
    hn::StoreU(nearest, d, near + first);
    return any;
  }
  /// Bits of those of the rays that met a child of the node that was opened last, which one did.
  HWY_INLINE std::uint64_t rays_that_met(std::size_t child, std::uint64_t who) const {
    if (is_one(who)) return who;
    const hn::CappedTag<std::uint8_t, kRaysAtOnce> d;
    const auto bit = hn::Set(d, static_cast<std::uint8_t>(1u << child));
    std::uint64_t rays = 0;
    for (std::size_t i = 0; i < kRaysAtOnce; i += hn::Lanes(d)) {
      std::uint8_t bytes[8] = {};
      hn::StoreMaskBits(d, hn::TestBit(hn::LoadU(d, met_ + i), bit), bytes);
      std::uint64_t part;
      std::memcpy(&part, bytes, sizeof part);
      rays |= part << i;
    }
    return rays & who;
  }

  static constexpr float kAway = 1.0f + 0x1p-20f;
  static constexpr double kFar = 0x1p-48;
  /// Least size of a direction, so that no product is without a number. Within a reach it makes no difference.
  static constexpr double kLeast = 0x1p-100;
  static constexpr std::size_t kMostWaiting = RayTree::kDeepest * (RayTree::kWidth - 1) + RayTree::kWidth;

  const RayTree& tree_;
  const RayColumns& rays_;
  Columns3<float> origin_;
  Columns3<float> inverse_;
  Column<float> limit_{};
  Column<double> begin_;
  std::uint64_t down_[3];               ///< bits of the rays that go down along each axis
  std::uint8_t met_[kRaysAtOnce] = {};  ///< bits of the children that each ray met last
  std::size_t size_ = 0;
  Waiting waiting_[kMostWaiting];
};

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
