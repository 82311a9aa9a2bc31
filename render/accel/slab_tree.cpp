#include "render/accel/slab_tree.h"

#include "render/math/interrupt.h"

#include <algorithm>
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

/// How far a list of extents reaches along an axis, as POV-Ray takes it: the far side of one that is farther than what is
/// known counts as if it had no length.
double reach(std::span<const std::uint32_t> list, const std::vector<SlabTree::Node>& nodes, std::size_t axis) {
  double low = kHuge;
  double high = -kHuge;
  for (const std::uint32_t number : list) {
    const Extent& extent = nodes[number].extent;
    low = std::min(low, static_cast<double>(extent.corner[axis]));
    if (extent.high(axis) > high) high = extent.corner[axis];
  }
  return high - low;
}

}  // namespace

SlabTree::SlabTree(std::span<const Extent> extents) {
  std::vector<std::uint32_t> list;
  std::vector<std::uint32_t> unbounded;
  nodes_.reserve(extents.size() + extents.size() / 2);
  for (const Extent& extent : extents) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({extent, extent.is_unbounded(), number, 0});
    (nodes_.back().unbounded ? unbounded : list).push_back(number);
  }
  // Each round groups what the round before has made, until all is in one group.
  while (!list.empty()) {
    const auto made = static_cast<std::uint32_t>(nodes_.size());
    std::vector<std::pair<std::size_t, std::size_t>> ranges = {{0, list.size()}};
    while (!ranges.empty()) {
      if (Interrupt::asked()) return;
      const auto [first, end] = ranges.back();
      ranges.pop_back();
      const std::span<std::uint32_t> range = std::span(list).subspan(first, end - first);
      sort(range);
      const std::size_t split = best_split(range);
      if (split == 0) {
        group(range);
      } else {
        ranges.emplace_back(first + split, end);
        ranges.emplace_back(first, first + split);
      }
    }
    root_ = static_cast<std::uint32_t>(nodes_.size()) - 1;
    if (root_ == made) break;
    list.clear();
    for (std::uint32_t number = made; number <= root_; ++number) list.push_back(number);
  }
  if (!unbounded.empty()) add_unbounded(unbounded);
}

/// Along the axis on which they reach farthest, by their middles; what has one middle keeps its order.
void SlabTree::sort(std::span<std::uint32_t> list) const {
  std::size_t along = 0;
  double farthest = -kHuge;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double far = reach(list, nodes_, axis);
    if (far > farthest) {
      farthest = far;
      along = axis;
    }
  }
  const auto twice_the_middle = [&](std::uint32_t number) {
    const Extent& extent = nodes_[number].extent;
    return static_cast<float>(2.0 * extent.corner[along] + extent.length[along]);
  };
  std::ranges::stable_sort(list, {}, twice_the_middle);
}

/// How many of the sorted are split off, so that the sum of surface times number is least; 0: they stay together.
std::size_t SlabTree::best_split(std::span<const std::uint32_t> sorted) const {
  const std::size_t size = sorted.size();
  if (size <= kBunch) return 0;
  std::vector<double> right(size);
  Hull hull;
  for (std::size_t i = size; i-- > 0;) {
    hull.add(nodes_[sorted[i]].extent);
    right[i] = hull.half_surface();
  }
  double least = right[0] * (static_cast<double>(size) - 3.0);
  std::size_t best = 0;
  Hull left;
  for (std::size_t i = 0; i + 1 < size; ++i) {
    left.add(nodes_[sorted[i]].extent);
    const auto count = static_cast<double>(i + 1);
    const double sum = count * left.half_surface() + (static_cast<double>(size) - count) * right[i + 1];
    if (!(sum < least)) continue;
    least = sum;
    best = i + 1;
  }
  return best;
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
