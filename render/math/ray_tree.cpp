#include "render/math/ray_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace firstlight::render {
namespace {

constexpr std::size_t kBins = 16;
constexpr std::size_t kMostInLeaf = 4;
/// From this depth on a node is halved by number, so that none lies deeper than 2^32 boxes need.
constexpr std::size_t kDeepestUneven = 32;
/// Room on all sides of a box, relative to its largest coordinate: planes of faces are kept in single precision.
constexpr double kRoom = 1e-6;

double half_area(const Box3& box) {
  if (box.isEmpty()) return 0.0;
  const Vec3 size = box.size();
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

struct Bin {
  Box3 box;
  std::size_t count = 0;
};

}  // namespace

RayTree::RayTree(std::span<const Box3> boxes) {
  if (boxes.empty()) return;
  order_.resize(boxes.size());
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(boxes.size());
  build(boxes, 0, boxes.size(), 0);
}

void RayTree::build(std::span<const Box3> boxes, std::size_t begin, std::size_t end, std::size_t depth) {
  Box3 all;
  Box3 centers;
  for (std::size_t i = begin; i < end; ++i) {
    all.extendBy(boxes[order_[i]]);
    centers.extendBy(boxes[order_[i]].center());
  }
  const std::size_t at = nodes_.size();
  Node& node = nodes_.emplace_back();
  const Box3 room = padded(all, kRoom, std::numeric_limits<float>::min());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node.low[axis] = std::nextafter(static_cast<float>(room.min[static_cast<int>(axis)]), -INFINITY);
    node.high[axis] = std::nextafter(static_cast<float>(room.max[static_cast<int>(axis)]), INFINITY);
  }
  node.first = static_cast<std::uint32_t>(begin);
  node.count = static_cast<std::uint16_t>(end - begin);
  node.axis = 0;
  if (end - begin <= kMostInLeaf) return;

  const auto first = order_.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = order_.begin() + static_cast<std::ptrdiff_t>(end);
  auto middle = first + (last - first) / 2;
  const unsigned axis = centers.majorAxis();
  const double low = centers.min[static_cast<int>(axis)];
  const double size = centers.max[static_cast<int>(axis)] - low;
  const auto center = [&](std::uint32_t box) { return boxes[box].center()[static_cast<int>(axis)]; };
  const auto bin_of = [&](std::uint32_t box) {
    return std::min(kBins - 1, static_cast<std::size_t>((center(box) - low) / size * static_cast<double>(kBins)));
  };
  bool halved = !(size > 0.0) || depth >= kDeepestUneven;
  if (!halved) {
    std::array<Bin, kBins> bins;
    for (auto box = first; box != last; ++box) {
      Bin& bin = bins[bin_of(*box)];
      bin.box.extendBy(boxes[*box]);
      ++bin.count;
    }
    // Cost of a cut below bin k: area times number of boxes, of both sides.
    std::array<double, kBins> cost{};
    Bin sum;
    for (std::size_t k = 1; k < kBins; ++k) {
      sum.box.extendBy(bins[k - 1].box);
      sum.count += bins[k - 1].count;
      cost[k] = half_area(sum.box) * static_cast<double>(sum.count);
    }
    sum = {};
    std::size_t best = 1;
    for (std::size_t k = kBins - 1; k > 0; --k) {
      sum.box.extendBy(bins[k].box);
      sum.count += bins[k].count;
      cost[k] += half_area(sum.box) * static_cast<double>(sum.count);
      if (cost[k] < cost[best]) best = k;
    }
    middle = std::stable_partition(first, last, [&](std::uint32_t box) { return bin_of(box) < best; });
    halved = middle == first || middle == last;
    if (halved) middle = first + (last - first) / 2;
  }
  if (halved) {
    std::nth_element(first, middle, last, [&](std::uint32_t a, std::uint32_t b) {
      return center(a) != center(b) ? center(a) < center(b) : a < b;
    });
  }
  const auto cut = static_cast<std::size_t>(middle - order_.begin());
  nodes_[at].count = 0;
  nodes_[at].axis = static_cast<std::uint16_t>(axis);
  build(boxes, begin, cut, depth + 1);
  nodes_[at].first = static_cast<std::uint32_t>(nodes_.size());
  build(boxes, cut, end, depth + 1);
}

}  // namespace firstlight::render
