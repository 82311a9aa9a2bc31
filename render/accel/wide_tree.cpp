#include "render/accel/wide_tree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace firstlight::render {
namespace {

constexpr double kLargestCoordinate = 1e15;

struct FloatBox {
  float low[3];
  float high[3];
};

float rounded_down(double v) {
  const float f = static_cast<float>(v);
  return static_cast<double>(f) > v ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}

float rounded_up(double v) {
  const float f = static_cast<float>(v);
  return static_cast<double>(f) < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

FloatBox rounded_out(const Box3& box) {
  FloatBox out;
  for (int axis = 0; axis < 3; ++axis) {
    out.low[axis] = rounded_down(box.min[axis]);
    out.high[axis] = rounded_up(box.max[axis]);
  }
  return out;
}

/// A node as the builder makes it: a leaf holds the number of its item, an inner node its children.
struct BuildNode {
  std::uint32_t item = 0;
  unsigned child_count = 0;  ///< 0: a leaf
  BuildNode* children[kTreeWidth] = {};
};

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
}

void set_children(void* node, void** children, unsigned count, void*) {
  auto& parent = *static_cast<BuildNode*>(node);
  parent.child_count = count;
  for (unsigned i = 0; i < count; ++i) parent.children[i] = static_cast<BuildNode*>(children[i]);
}

void set_bounds(void*, const RTCBounds**, unsigned, void*) {}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t, void*) {
  auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
  leaf->item = primitives[0].primID;
  return leaf;
}

/// Lays the builder's nodes out in one array, each before its children, and gives every node its boxes.
class Flattener {
 public:
  Flattener(std::span<const TreeItem> items, std::span<const FloatBox> boxes, std::vector<WideNode>& nodes)
      : items_(items), boxes_(boxes), nodes_(nodes) {}

  /// A tree of one item still gets a node.
  void flatten(const BuildNode& root) {
    BuildNode single;
    single.child_count = 1;
    single.children[0] = const_cast<BuildNode*>(&root);
    add(root.child_count > 0 ? root : single, 1);
  }
  std::size_t depth() const { return depth_; }

 private:
  FloatBox add(const BuildNode& from, std::size_t depth) {
    depth_ = std::max(depth_, depth);
    const std::size_t index = nodes_.size();
    nodes_.emplace_back();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    FloatBox all{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
    for (unsigned slot = 0; slot < kTreeWidth; ++slot) {
      FloatBox box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
      ChildRef ref{0};
      if (slot < from.child_count) {
        const BuildNode& child = *from.children[slot];
        if (child.child_count == 0) {
          box = boxes_[child.item];
          ref = items_[child.item].leaf;
        } else {
          ref = ChildRef::of(ChildKind::node, static_cast<std::uint32_t>(nodes_.size()));
          box = add(child, depth + 1);
        }
      }
      WideNode& node = nodes_[index];
      node.child[slot] = ref;
      for (int axis = 0; axis < 3; ++axis) {
        node.bounds[2 * axis][slot] = box.low[axis];
        node.bounds[2 * axis + 1][slot] = box.high[axis];
        all.low[axis] = std::min(all.low[axis], box.low[axis]);
        all.high[axis] = std::max(all.high[axis], box.high[axis]);
      }
    }
    return all;
  }

  std::span<const TreeItem> items_;
  std::span<const FloatBox> boxes_;
  std::vector<WideNode>& nodes_;
  std::size_t depth_ = 0;
};

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseTree {
  void operator()(RTCBVH tree) const { rtcReleaseBVH(tree); }
};

}  // namespace

bool WideTree::fits(const Box3& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.min[axis] >= -kLargestCoordinate && box.max[axis] <= kLargestCoordinate)) return false;
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
    const FloatBox& box = boxes[i] = rounded_out(items[i].box);
    primitives[i] = {box.low[0],  box.low[1],  box.low[2],  0,
                     box.high[0], box.high[1], box.high[2], static_cast<unsigned>(i)};
  }
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = kTreeWidth;
  arguments.maxDepth = kTreeDepth - 16;  // the builder goes a few levels beyond when it meets the limit
  arguments.sahBlockSize = 1;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = 1;
  arguments.bvh = tree.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  const auto* root = static_cast<const BuildNode*>(rtcBuildBVH(&arguments));
  if (!root) return;

  nodes_.reserve(items.size() / 4 + 1);
  Flattener flattener(items, boxes, nodes_);
  flattener.flatten(*root);
  built_ = flattener.depth() <= kTreeDepth;
  if (!built_) nodes_.clear();
}

}  // namespace firstlight::render
