#include "render/math/ray_tree.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/math/ray_tree.cpp"
#include <hwy/foreach_target.h>

#include "render/math/ray_tree-inl.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

void find_boxes(const RayTree& tree, const RayColumns& rays, std::uint64_t who, const Column<double>& high,
                std::vector<RayTree::Found>& out) {
  const auto add = [&](std::uint32_t leaf, std::uint64_t coming) HWY_ATTR {
    for (; coming != 0; coming &= coming - 1) {
      const auto ray = static_cast<std::uint32_t>(__builtin_ctzll(coming));
      for (const std::uint32_t box : tree.leaves()[leaf]) {
        if (box != RayTree::kNone) out.push_back({ray, box});
      }
    }
  };
  TreeWalk(tree, rays).walk(who, high, add, [&](std::uint32_t leaf) HWY_ATTR { fetch_ahead(tree.leaves()[leaf]); });
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

constexpr std::size_t kBins = 16;
/// From this depth on a part is halved by number, so that none lies deeper than 2^31 boxes need.
constexpr std::size_t kDeepestUneven = 32;
/// Room on all sides of a box, relative to the largest coordinate: planes of faces are kept in single precision, and
/// TreeWalk needs a quarter of it.
constexpr double kRoom = 1e-6;

float half_area(const Imath::Box3f& box) {
  if (box.isEmpty()) return 0.0f;
  const Imath::V3f size = box.size();
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// Cost of testing so many boxes.
float cost_of(std::size_t count, std::size_t leaf_size) {
  return static_cast<float>((count + leaf_size - 1) / leaf_size);
}

/// Without branches, which could not be foretold.
void extend(Imath::Box3f& box, const Imath::V3f& low, const Imath::V3f& high) {
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = std::min(box.min[axis], low[axis]);
    box.max[axis] = std::max(box.max[axis], high[axis]);
  }
}

Imath::V3f center_of(const RayTree::Item& item) { return (item.box.min + item.box.max) * 0.5f; }

struct Bin {
  Imath::Box3f box;
  std::size_t count = 0;
};

}  // namespace

HWY_EXPORT(find_boxes);

void RayTree::find(const RayColumns& rays, std::uint64_t who, const Column<double>& high,
                   std::vector<Found>& out) const {
  HWY_DYNAMIC_DISPATCH(find_boxes)(*this, rays, who, high, out);
}

void RayTree::find(const Ray& ray, double high, std::vector<Found>& out) const {
  find(alone(ray), 1, alone(high), out);
}

/// Some of the boxes on their way to a node or a leaf.
struct RayTree::Part {
  std::size_t begin;
  std::size_t end;
  Imath::Box3f box;
  Imath::Box3f centers;
  std::size_t depth = 0;  ///< how often it was cut
  int axis = 0;           ///< along which it was cut last

  std::size_t size() const { return end - begin; }
  void hold(const Item& item) {
    extend(box, item.box.min, item.box.max);
    const Imath::V3f center = center_of(item);
    extend(centers, center, center);
  }
  /// Keeps the lower of two parts, and returns the upper. Pre: it has two boxes or more.
  Part cut(std::span<Item> items, std::size_t leaf_size);
};

RayTree::Part RayTree::Part::cut(std::span<Item> items, std::size_t leaf_size) {
  const std::span<Item> own = items.subspan(begin, size());
  axis = static_cast<int>(centers.majorAxis());
  const float low = centers.min[axis];
  const float extent = centers.max[axis] - low;
  const float scale = static_cast<float>(kBins) / extent;
  const auto bin_of = [&](const Item& item) {
    const float place = ((item.box.min[axis] + item.box.max[axis]) * 0.5f - low) * scale;
    return place > 0.0f ? static_cast<std::size_t>(std::min(place, kBins - 1.0f)) : std::size_t{0};
  };
  auto middle = own.begin();
  if (extent > 0.0f && depth < kDeepestUneven) {
    std::array<Bin, kBins> bins;
    for (const Item& item : own) {
      Bin& bin = bins[bin_of(item)];
      extend(bin.box, item.box.min, item.box.max);
      ++bin.count;
    }
    // Cost of a cut below bin k: area times number of boxes, of both sides.
    std::array<float, kBins> cost{};
    Bin sum;
    for (std::size_t k = 1; k < kBins; ++k) {
      sum.box.extendBy(bins[k - 1].box);
      sum.count += bins[k - 1].count;
      cost[k] = half_area(sum.box) * cost_of(sum.count, leaf_size);
    }
    sum = {};
    std::size_t best = 1;
    for (std::size_t k = kBins - 1; k > 0; --k) {
      sum.box.extendBy(bins[k].box);
      sum.count += bins[k].count;
      cost[k] += half_area(sum.box) * cost_of(sum.count, leaf_size);
      if (cost[k] < cost[best]) best = k;
    }
    middle = std::partition(own.begin(), own.end(), [&](const Item& item) { return bin_of(item) < best; });
  }
  if (middle == own.begin() || middle == own.end()) {
    middle = own.begin() + static_cast<std::ptrdiff_t>(own.size() / 2);
    std::nth_element(own.begin(), middle, own.end(), [&](const Item& a, const Item& b) {
      const float of_a = center_of(a)[axis], of_b = center_of(b)[axis];
      return of_a != of_b ? of_a < of_b : a.number < b.number;
    });
  }
  const std::size_t cut = begin + static_cast<std::size_t>(middle - own.begin());
  Part lower{begin, cut, {}, {}, depth + 1, axis};
  Part upper{cut, end, {}, {}, depth + 1, axis};
  for (std::size_t i = begin; i < end; ++i) (i < cut ? lower : upper).hold(items[i]);
  *this = lower;
  return upper;
}

RayTree::RayTree(std::vector<Item> items) { build(items); }

RayTree::RayTree(std::span<const Box3> boxes, std::size_t leaf_size) : leaf_size_(leaf_size) {
  std::vector<Item> items;
  items.reserve(boxes.size());
  for (const Box3& box : boxes) {
    items.push_back({{Imath::V3f(box.min), Imath::V3f(box.max)}, static_cast<std::uint32_t>(items.size())});
  }
  build(items);
}

void RayTree::build(std::span<Item> items) {
  if (items.empty()) return;
  Part whole{0, items.size(), {}, {}};
  for (const Item& item : items) whole.hold(item);
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = whole.box.min[axis], high = whole.box.max[axis];
    middle_[axis] = (low + high) / 2.0;
    reach_[axis] = (high - low) / 2.0;
    largest = std::max({largest, std::abs(low), std::abs(high)});
  }
  room_ = largest * kRoom + std::numeric_limits<float>::min();
  reach_ += Vec3(room_);
  nodes_.reserve(items.size() / 24);
  leaves_.reserve(items.size() / 5);
  add_node(items, whole);
}

/// The box beside the middle.
Imath::Box3f RayTree::with_room(const Imath::Box3f& box) const {
  Imath::Box3f with;
  for (int axis = 0; axis < 3; ++axis) {
    const auto low = static_cast<float>(box.min[axis] - middle_[axis] - room_);
    const auto high = static_cast<float>(box.max[axis] - middle_[axis] + room_);
    with.min[axis] = std::nextafter(low, -std::numeric_limits<float>::infinity());
    with.max[axis] = std::nextafter(high, std::numeric_limits<float>::infinity());
  }
  return with;
}

namespace {

/// The children of a node, in the order in which rays of each octant come to them.
class Orders {
 public:
  Orders() {
    for (auto& order : orders_) order[0] = 0;
  }
  /// The upper half of child `lower`, cut along `axis`, becomes a child of its own: the next one.
  void cut(std::size_t lower, int axis) {
    for (unsigned octant = 0; octant < orders_.size(); ++octant) {
      auto& order = orders_[octant];
      const auto end = order.begin() + static_cast<std::ptrdiff_t>(count_);
      auto place = std::find(order.begin(), end, lower);
      if ((octant >> axis & 1) == 0) ++place;
      std::copy_backward(place, end, end + 1);
      *place = static_cast<std::uint32_t>(count_);
    }
    ++count_;
  }
  std::uint32_t packed(unsigned octant) const {
    auto packed = static_cast<std::uint32_t>(count_) << RayTree::Node::kCountShift;
    for (std::size_t n = 0; n < count_; ++n) packed |= orders_[octant][n] << 3 * n;
    return packed;
  }

 private:
  std::array<std::array<std::uint32_t, RayTree::kWidth>, 8> orders_;
  std::size_t count_ = 1;
};

}  // namespace

/// The largest part that is too large for a leaf is cut until there are enough.
void RayTree::add_node(std::span<Item> items, const Part& whole) {
  std::array<Part, kWidth> parts;
  parts[0] = whole;
  std::size_t count = 1;
  Orders orders;
  while (count < kWidth) {
    Part* largest = nullptr;
    for (std::size_t i = 0; i < count; ++i) {
      Part& part = parts[i];
      if (part.size() > leaf_size_ && (!largest || half_area(part.box) > half_area(largest->box))) largest = &part;
    }
    if (largest == nullptr) break;
    parts[count++] = largest->cut(items, leaf_size_);
    orders.cut(static_cast<std::size_t>(largest - parts.data()), largest->axis);
  }
  const std::size_t at = nodes_.size();
  nodes_.push_back({});
  for (unsigned octant = 0; octant < 8; ++octant) nodes_[at].order[octant] = orders.packed(octant);
  for (std::size_t i = 0; i < count; ++i) {
    const Part& part = parts[i];
    Child child = Child::node(nodes_.size());
    if (part.size() <= leaf_size_) {
      child = add_leaf(items.subspan(part.begin, part.size()));
    } else {
      add_node(items, part);
    }
    const Imath::Box3f box = with_room(part.box);
    Node& node = nodes_[at];
    for (int axis = 0; axis < 3; ++axis) {
      node.bounds[2 * axis][i] = box.min[axis];
      node.bounds[2 * axis + 1][i] = box.max[axis];
    }
    node.child[i] = child;
  }
}

RayTree::Child RayTree::add_leaf(std::span<const Item> items) {
  Leaf& leaf = leaves_.emplace_back();
  leaf.fill(kNone);
  for (std::size_t i = 0; i < items.size(); ++i) leaf[i] = items[i].number;
  return Child::leaf(leaves_.size() - 1);
}

}  // namespace firstlight::render
#endif
