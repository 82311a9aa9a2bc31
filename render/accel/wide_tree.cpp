#include "render/accel/wide_tree.h"

#include "render/math/interrupt.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

namespace firstlight::render {
namespace {

constexpr std::size_t kLargestLeaf = std::tuple_size_v<SphereGroup>;
static_assert(kLargestLeaf <= kTreeWidth, "a leaf of mixed items becomes one node");

/// A node as the builder makes it: a leaf holds the numbers of its items, an inner node its children.
struct BuildNode {
  unsigned item_count = 0;
  unsigned child_count = 0;  ///< 0: a leaf
  union {
    std::uint32_t items[kLargestLeaf];
    BuildNode* children[kTreeWidth];
  };
};

BuildNode* allocate(RTCThreadLocalAllocator allocator) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
}

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) { return allocate(allocator); }

void set_children(void* node, void** children, unsigned count, void*) {
  auto& parent = *static_cast<BuildNode*>(node);
  parent.child_count = count;
  for (unsigned i = 0; i < count; ++i) parent.children[i] = static_cast<BuildNode*>(children[i]);
}

/// The builder runs on threads of its own, too. `wish` may be null.
bool goes_on(void* wish, double) {
  return wish == nullptr || !static_cast<const std::atomic<bool>*>(wish)->load(std::memory_order_relaxed);
}

void set_bounds(void*, const RTCBounds**, unsigned, void*) {}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count, void*) {
  BuildNode* leaf = allocate(allocator);
  leaf->item_count = static_cast<unsigned>(count);
  for (std::size_t i = 0; i < count; ++i) leaf->items[i] = primitives[i].primID;
  return leaf;
}

/// The box with the room that WideNode promises, and some for faces near zero, where floats lose their precision.
FloatBox with_room(const FloatBox& box) {
  constexpr double kLeastRoom = 1e-30;
  Box3 wider;
  for (int axis = 0; axis < 3; ++axis) {
    wider.min[axis] = box.low[axis] - std::abs(box.low[axis]) * WideNode::kFaceRoom - kLeastRoom;
    wider.max[axis] = box.high[axis] + std::abs(box.high[axis]) * WideNode::kFaceRoom + kLeastRoom;
  }
  return FloatBox(wider);
}

/// Lays the builder's nodes out in one array, each before its children, and gives every node its boxes.
class Flattener {
 public:
  Flattener(std::span<const TreeItem> items, std::span<const FloatBox> boxes, std::vector<WideNode>& nodes,
            std::vector<SphereGroup>& groups)
      : items_(items), boxes_(boxes), nodes_(nodes), groups_(groups) {}

  /// Returns the box of everything.
  FloatBox flatten(const BuildNode& root) { return with_room(add_node(root, 1).box); }
  std::size_t depth() const { return depth_; }

 private:
  struct Slot {
    FloatBox box;
    ChildRef ref;
  };

  /// `from` may be a leaf: then its items are the children.
  Slot add_node(const BuildNode& from, std::size_t depth) {
    depth_ = std::max(depth_, depth);
    const std::size_t index = nodes_.size();
    nodes_.emplace_back();
    FloatBox all;
    std::size_t used = 0;
    const auto fill = [&](const Slot& slot) {
      put(index, used++, slot);
      all.extend(slot.box);
    };
    if (from.child_count == 0) {
      const std::span<const std::uint32_t> leaf(from.items, from.item_count);
      if (const Slot spheres = sphere_group(leaf); !is_empty(spheres)) fill(spheres);
      for (const std::uint32_t item : leaf) {
        if (!is_sphere(item)) fill({boxes_[item], items_[item].leaf});
      }
    }
    for (unsigned i = 0; i < from.child_count; ++i) fill(add(*from.children[i], depth + 1));
    while (used < kTreeWidth) put(index, used++, Slot{FloatBox(), ChildRef{0}});
    return {all, ChildRef::of(ChildKind::node, static_cast<std::uint32_t>(index))};
  }

  /// A leaf of nothing but spheres, or of one item, needs no node of its own.
  Slot add(const BuildNode& from, std::size_t depth) {
    if (from.child_count > 0) return add_node(from, depth);
    const std::span<const std::uint32_t> leaf(from.items, from.item_count);
    if (std::all_of(leaf.begin(), leaf.end(), [&](std::uint32_t item) { return is_sphere(item); })) {
      return sphere_group(leaf);
    }
    if (leaf.size() == 1) return {boxes_[leaf[0]], items_[leaf[0]].leaf};
    return add_node(from, depth);
  }

  /// The spheres of a leaf as one group; an empty box when it has none.
  Slot sphere_group(std::span<const std::uint32_t> leaf) {
    SphereGroup group;
    group.fill(kNoSphere);
    std::size_t size = 0;
    FloatBox all;
    for (const std::uint32_t item : leaf) {
      if (!is_sphere(item)) continue;
      group[size++] = items_[item].leaf.index();
      all.extend(boxes_[item]);
    }
    if (size == 0) return {all, ChildRef{0}};
    groups_.push_back(group);
    return {all, ChildRef::of(ChildKind::sphere, static_cast<std::uint32_t>(groups_.size() - 1))};
  }

  void put(std::size_t index, std::size_t place, const Slot& slot) {
    WideNode& node = nodes_[index];
    const FloatBox box = is_empty(slot) ? slot.box : with_room(slot.box);
    node.child[place] = slot.ref;
    for (int axis = 0; axis < 3; ++axis) {
      node.bounds[2 * axis][place] = box.low[axis];
      node.bounds[2 * axis + 1][place] = box.high[axis];
    }
  }

  static bool is_empty(const Slot& slot) { return slot.box.low[0] > slot.box.high[0]; }
  bool is_sphere(std::uint32_t item) const { return items_[item].leaf.kind() == ChildKind::sphere; }

  std::span<const TreeItem> items_;
  std::span<const FloatBox> boxes_;
  std::vector<WideNode>& nodes_;
  std::vector<SphereGroup>& groups_;
  std::size_t depth_ = 0;
};

/// The margin may have a 64th of the size that seven of eight items have at least.
FloatLimits limits_of(std::span<const TreeItem> items) {
  double reach = 0.0;
  std::vector<double> sizes;
  sizes.reserve(items.size());
  for (const TreeItem& item : items) {
    double size = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      size = std::max(size, item.box.max[axis] - item.box.min[axis]);
      reach = std::max({reach, std::abs(item.box.min[axis]), std::abs(item.box.max[axis])});
    }
    sizes.push_back(size);
  }
  const auto few = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 8);
  std::nth_element(sizes.begin(), few, sizes.end());
  const double farthest = std::min(*few * 0x1p14, FloatBox::kLargestCoordinate);  // 2^-6 of the size over 2^-20
  const double shared = (farthest + reach) * 0x1p-48 + 1e-30;                     // and room for denormal numbers
  if (!(shared <= *few * 0x1p-6)) return FloatLimits();
  return {static_cast<float>(farthest), static_cast<float>(shared * 1.001)};
}

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseTree {
  void operator()(RTCBVH tree) const { rtcReleaseBVH(tree); }
};

}  // namespace

bool WideTree::fits(const Box3& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.min[axis] >= -FloatBox::kLargestCoordinate && box.max[axis] <= FloatBox::kLargestCoordinate)) {
      return false;
    }
  }
  return true;
}

WideTree::WideTree(std::span<const TreeItem> items) {
  if (items.empty()) return;
  built_ = false;
  const std::unique_ptr<RTCDeviceTy, ReleaseDevice> device(rtcNewDevice(nullptr));
  if (!device) return;
  const std::unique_ptr<RTCBVHTy, ReleaseTree> tree(rtcNewBVH(device.get()));
  if (!tree) return;

  std::vector<FloatBox> boxes(items.size());
  std::vector<RTCBuildPrimitive> primitives(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const FloatBox& box = boxes[i] = FloatBox(items[i].box);
    primitives[i] = {box.low[0],  box.low[1],  box.low[2],  0,
                     box.high[0], box.high[1], box.high[2], static_cast<unsigned>(i)};
  }
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = kTreeWidth;
  arguments.maxDepth = kTreeDepth - 16;  // the builder goes a few levels beyond when it meets the limit
  arguments.sahBlockSize = kLargestLeaf;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = kLargestLeaf;
  arguments.bvh = tree.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  arguments.buildProgress = goes_on;
  arguments.userPtr = const_cast<std::atomic<bool>*>(Interrupt::wish());
  const auto* root = static_cast<const BuildNode*>(rtcBuildBVH(&arguments));
  if (!root || Interrupt::asked()) return;

  nodes_.reserve(items.size() / 4 + 1);
  Flattener flattener(items, boxes, nodes_, sphere_groups_);
  bounds_ = flattener.flatten(*root);
  built_ = flattener.depth() <= kTreeDepth;
  if (!built_) {
    nodes_.clear();
    sphere_groups_.clear();
  }
  float_limits_ = limits_of(items);
}

}  // namespace firstlight::render
