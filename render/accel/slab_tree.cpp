#include "render/accel/slab_tree.h"

#include "render/math/interrupt.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace firstlight::render {
namespace {

/// So many are not split.
constexpr std::size_t kBunch = 4;
constexpr double kHuge = 2e10;

/// The corners of a growing box, in double precision.
struct Hull {
  double low[3] = {kHuge, kHuge, kHuge};
  double high[3] = {-kHuge, -kHuge, -kHuge};

  void add(const Extent& extent) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double from = extent.corner[axis];
      low[axis] = std::min(low[axis], from);
      high[axis] = std::max(high[axis], from + static_cast<double>(extent.length[axis]));
    }
  }
  double half_surface() const {
    const double x = high[0] - low[0];
    const double y = high[1] - low[1];
    const double z = high[2] - low[2];
    return x * (y + z) + y * z;
  }
  Extent extent() const { return Extent(Box3(Vec3(low[0], low[1], low[2]), Vec3(high[0], high[1], high[2]))); }
};

/// A node that is to be grouped, with its extent beside it.
struct Member {
  Extent extent;
  std::uint32_t node;
};

/// How far members reach along an axis, as POV-Ray takes it: the far side of one that is farther than what is known
/// counts as if it had no length.
double reach(std::span<const Member> members, std::size_t axis) {
  double low = kHuge;
  double high = -kHuge;
  for (const Member& member : members) {
    low = std::min(low, static_cast<double>(member.extent.corner[axis]));
    if (member.extent.high(axis) > high) high = member.extent.corner[axis];
  }
  return high - low;
}

/// A whole number for each real one, in the same order; both zeros have one.
std::uint32_t rank(float value) {
  constexpr std::uint32_t kSign = 0x80000000U;
  const auto bits = std::bit_cast<std::uint32_t>(value + 0.0F);
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

/// Sorts and splits ranges of members.
class Splitter {
 public:
  /// Sorts along the axis on which they reach farthest, by their middles; what has one middle keeps its order.
  void sort(std::span<Member> members) {
    std::size_t along = 0;
    double farthest = -kHuge;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double far = reach(members, axis);
      if (far > farthest) {
        farthest = far;
        along = axis;
      }
    }
    keys_.clear();
    for (const auto& [extent, node] : members) {
      const auto twice_the_middle = static_cast<float>(2.0 * extent.corner[along] + extent.length[along]);
      keys_.push_back(std::uint64_t{rank(twice_the_middle)} << 32 | keys_.size());
    }
    if (std::ranges::is_sorted(keys_)) return;
    std::ranges::sort(keys_);
    before_.assign(members.begin(), members.end());
    for (std::size_t i = 0; i < members.size(); ++i) members[i] = before_[static_cast<std::uint32_t>(keys_[i])];
  }

  /// How many of the sorted are split off, so that the sum of surface times number is least; 0: they stay together.
  std::size_t best_split(std::span<const Member> sorted) {
    const std::size_t size = sorted.size();
    if (size <= kBunch) return 0;
    right_.resize(size);
    Hull hull;
    for (std::size_t i = size; i-- > 0;) {
      hull.add(sorted[i].extent);
      right_[i] = hull.half_surface();
    }
    double least = right_[0] * (static_cast<double>(size) - 3.0);
    std::size_t best = 0;
    Hull left;
    for (std::size_t i = 0; i + 1 < size; ++i) {
      left.add(sorted[i].extent);
      const auto count = static_cast<double>(i + 1);
      const double sum = count * left.half_surface() + (static_cast<double>(size) - count) * right_[i + 1];
      if (!(sum < least)) continue;
      least = sum;
      best = i + 1;
    }
    return best;
  }

 private:
  std::vector<std::uint64_t> keys_;  ///< the rank of a member's middle, then its place
  std::vector<Member> before_;
  std::vector<double> right_;  ///< half the surface of all from here on
};

}  // namespace

SlabTree::SlabTree(std::span<const Extent> extents) {
  std::vector<Member> list;
  std::vector<std::uint32_t> unbounded;
  nodes_.reserve(extents.size() + extents.size() / 2);
  for (const Extent& extent : extents) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({extent, extent.is_unbounded(), number, 0});
    if (nodes_.back().unbounded) {
      unbounded.push_back(number);
    } else {
      list.push_back({extent, number});
    }
  }
  // Each round groups what the round before has made, until all is in one group.
  Splitter splitter;
  std::vector<std::uint32_t> members;
  while (!list.empty()) {
    const auto made = static_cast<std::uint32_t>(nodes_.size());
    std::vector<std::pair<std::size_t, std::size_t>> ranges = {{0, list.size()}};
    while (!ranges.empty()) {
      if (Interrupt::asked()) return;
      const auto [first, end] = ranges.back();
      ranges.pop_back();
      const std::span<Member> range = std::span(list).subspan(first, end - first);
      splitter.sort(range);
      const std::size_t split = splitter.best_split(range);
      if (split == 0) {
        members.clear();
        for (const Member& member : range) members.push_back(member.node);
        group(members);
      } else {
        ranges.emplace_back(first + split, end);
        ranges.emplace_back(first, first + split);
      }
    }
    root_ = static_cast<std::uint32_t>(nodes_.size()) - 1;
    if (root_ == made) break;
    list.clear();
    for (std::uint32_t number = made; number <= root_; ++number) list.push_back({nodes_[number].extent, number});
  }
  if (!unbounded.empty()) add_unbounded(unbounded);
}

void SlabTree::group(std::span<const std::uint32_t> members) {
  Hull hull;
  for (const std::uint32_t member : members) hull.add(nodes_[member].extent);
  nodes_.push_back(
      {hull.extent(), false, static_cast<std::uint32_t>(children_.size()), static_cast<std::uint32_t>(members.size())});
  children_.insert(children_.end(), members.begin(), members.end());
}

/// They are one group, the first of the root's; or the root, where nothing else is.
void SlabTree::add_unbounded(std::span<const std::uint32_t> unbounded) {
  const bool alone = nodes_.size() == unbounded.size();
  group(unbounded);
  nodes_.back().unbounded = true;
  const auto together = static_cast<std::uint32_t>(nodes_.size()) - 1;
  if (alone) {
    root_ = together;
    return;
  }
  std::vector<std::uint32_t> members = {together};
  std::ranges::copy(children(nodes_[root_]), std::back_inserter(members));
  group(members);
  nodes_.back().unbounded = true;
  root_ = static_cast<std::uint32_t>(nodes_.size()) - 1;
}

}  // namespace firstlight::render
