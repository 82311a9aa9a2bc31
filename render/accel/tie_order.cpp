#include "render/accel/tie_order.h"

#include "render/math/interrupt.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

/// Fewer objects and lights are not bounded. [POV-Ray 3.7]
constexpr std::size_t kBoundingThreshold = 3;
/// Where what has no bounds is entered.
constexpr double kBeforeAll = -1e7;
constexpr double kHuge = 2e10;
constexpr double kEpsilonDepth = 1e-10;

/// A ray as boxes are tested with it, in single precision.
class SlabRay {
 public:
  explicit SlabRay(const Ray& ray) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      origin_[at] = static_cast<float>(ray.origin[axis]);
      const double direction = ray.direction[axis];
      moves_[at] = direction != 0.0;
      upwards_[at] = direction > 0.0;
      if (moves_[at]) inverse_[at] = static_cast<float>(1.0 / direction);
    }
  }

  /// Whether the ray meets the box, and where it enters it; below zero where it starts inside. Rounded as in POV-Ray:
  /// slabs in single precision, compared in double.
  bool enters(const Extent& box, double& depth) const {
    double near = -kHuge;
    double far = kHuge;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!moves_[axis]) {
        if (origin_[axis] < box.corner[axis] || origin_[axis] > box.high(axis)) return false;
        continue;
      }
      const double at_corner = (box.corner[axis] - origin_[axis]) * inverse_[axis];
      const double across = box.length[axis] * inverse_[axis];
      const double enter = upwards_[axis] ? at_corner : at_corner + across;
      const double leave = upwards_[axis] ? at_corner + across : at_corner;
      if (leave < far) {
        if (leave < kEpsilonDepth) return false;
        far = leave;
      }
      if (enter > near) near = enter;
      if (near > far) return false;
    }
    depth = near;
    return true;
  }

 private:
  std::array<float, 3> origin_;
  std::array<float, 3> inverse_;
  std::array<bool, 3> moves_;
  std::array<bool, 3> upwards_;
};

/// A binary heap of nodes, the one that is entered first on top. Of equal depths it depends on all that came before which
/// one leaves first, so every step is POV-Ray's.
class NodeHeap {
 public:
  struct Entry {
    double depth;
    std::uint32_t node;
  };

  void clear() { entries_.assign(1, {}); }
  bool empty() const { return entries_.size() == 1; }

  void push(double depth, std::uint32_t node) {
    std::size_t at = entries_.size();
    entries_.emplace_back();
    for (; at > 1 && depth < entries_[at / 2].depth; at /= 2) entries_[at] = entries_[at / 2];
    entries_[at] = {depth, node};
  }

  Entry pop() {
    const Entry top = entries_[1];
    entries_[1] = entries_.back();
    entries_.pop_back();
    const std::size_t last = entries_.size() - 1;
    for (std::size_t at = 1; 2 * at <= last;) {
      const std::size_t left = 2 * at;
      const std::size_t next = left == last || entries_[left].depth < entries_[left + 1].depth ? left : left + 1;
      if (!(entries_[at].depth > entries_[next].depth)) break;
      std::swap(entries_[at], entries_[next]);
      at = next;
    }
    return top;
  }

 private:
  std::vector<Entry> entries_;  ///< from 1 on
};

}  // namespace

/// One ray, and the nearest crossing of the solids that were asked so far.
class TieOrder::Search {
 public:
  Search(const Scene& scene, const RayBlock& rays, std::size_t i)
      : scene_(scene),
        ray_{rays.origin.vector(i), rays.direction.vector(i)},
        hidden_bit_(static_cast<std::uint8_t>(rays.hidden_bit[i])),
        min_depth_(rays.min_depth[i]) {
    best_.depth = rays.max_depth[i];
  }

  const Ray& ray() const { return ray_; }
  double nearest() const { return best_.depth; }
  Hit result() const { return best_.part == kNoIndex ? Hit() : best_; }

  void ask(std::uint32_t number, const Box3& box) {
    const Solid& solid = scene_.solids[number];
    if ((solid.hidden_from & hidden_bit_) != 0 || !meets(ray_, box)) return;
    thread_local std::vector<Crossing> crossings;
    crossings.clear();
    solid.crossings(ray_, hidden_bit_, crossings);
    for (std::size_t c = crossings.size(); c-- > 0;) {
      const Crossing& crossing = crossings[c];
      if (!(crossing.depth > min_depth_ && crossing.depth < best_.depth)) continue;
      best_ = Hit(crossing, number);
    }
  }

 private:
  const Scene& scene_;
  Ray ray_;
  std::uint8_t hidden_bit_;
  double min_depth_;
  Hit best_;
};

/// The first who asks plants it; what an interrupt has left unfinished nobody else will use.
const TieOrder::Planted& TieOrder::planted() const {
  if (const Planted* ready = ready_.load(std::memory_order_acquire)) return *ready;
  const std::scoped_lock lock(planting_);
  if (!planted_) {
    std::vector<Extent> extents;
    std::vector<Box3> boxes;
    extents.reserve(scene_.solids.size());
    boxes.reserve(scene_.solids.size());
    for (const Solid& solid : scene_.solids) {
      extents.push_back(solid.extent());
      boxes.push_back(solid.box());
    }
    planted_ = std::make_unique<const Planted>(Planted{SlabTree(extents), std::move(boxes)});
    ready_.store(planted_.get(), std::memory_order_release);
  }
  return *planted_;
}

Hit TieOrder::seen(const RayBlock& rays, std::size_t i) const {
  Search search(scene_, rays, i);
  if (scene_.solids.size() + scene_.lights.size() < kBoundingThreshold) {
    for (std::uint32_t solid = 0; solid < scene_.solids.size(); ++solid) {
      search.ask(solid, scene_.solids[solid].box());
    }
    return search.result();
  }
  const SlabTree& tree = planted().tree;
  const std::vector<Box3>& boxes = planted().boxes;
  const SlabRay ray(search.ray());
  thread_local NodeHeap heap;
  heap.clear();
  const auto push = [&](std::uint32_t number) {
    const SlabTree::Node& node = tree.node(number);
    double depth = kBeforeAll;
    if (node.unbounded || ray.enters(node.extent, depth)) heap.push(depth, number);
  };
  push(tree.root());
  while (!heap.empty() && !Interrupt::asked()) {
    const NodeHeap::Entry entry = heap.pop();
    if (entry.depth > search.nearest()) break;
    const SlabTree::Node& node = tree.node(entry.node);
    if (node.count == 0) {
      search.ask(node.first, boxes[node.first]);
    } else {
      for (const std::uint32_t child : tree.children(node)) push(child);
    }
  }
  return search.result();
}

}  // namespace firstlight::render
