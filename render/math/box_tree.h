#pragma once

#include "render/math/block_tests.h"
#include "render/math/bounds.h"
#include "render/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// Finds among many boxes those that a ray meets or that hold a point. Small and simple: for the members of one object;
/// a whole scene has the acceleration structure.
///
/// Cost     built in O(n log^2 n) by halving along the longest axis; boundless boxes are tested always.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Box3> boxes);

  /// Appends the indices of the boxes that the ray meets, in no particular order.
  void met_by(const Ray& ray, std::vector<std::uint32_t>& out) const;

  /// Whether `accepts(index)` holds for any of the boxes that hold the point.
  template <class Accepts>
  bool any_around(const Vec3& point, const Accepts& accepts) const {
    for (const std::uint32_t index : boundless_) {
      if (accepts(index)) return true;
    }
    std::uint32_t at = 0;
    while (at < nodes_.size()) {
      const Node& node = nodes_[at];
      if (!node.box.intersects(point)) {
        at = node.after;
        continue;
      }
      if (node.index != kInner && accepts(node.index)) return true;
      ++at;
    }
    return false;
  }

  /// visit(index, rays) for each box that some of the rays in `who` meet, with which, in no particular order.
  template <class Visit>
  void for_each_met(const RayColumns& rays, const Columns3<double>& inverse, std::uint64_t who,
                    const Visit& visit) const {
    for (const std::uint32_t index : boundless_) visit(index, who);
    std::uint32_t at = 0;
    while (at < nodes_.size()) {
      const Node& node = nodes_[at];
      const std::uint64_t here = meeting(rays, inverse, node.box, who);
      if (here == 0) {
        at = node.after;
        continue;
      }
      if (node.index != kInner) visit(node.index, here);
      ++at;
    }
  }
  /// left = visit(index, points, left) for each box that holds some of the points that are left, with which of them;
  /// `who` are left at first. Returns those that are at the end.
  template <class Visit>
  std::uint64_t for_each_around(const Columns3<double>& points, std::uint64_t who, const Visit& visit) const {
    std::uint64_t left = who;
    for (std::size_t b = 0; b < boundless_.size() && left != 0; ++b) left = visit(boundless_[b], left, left);
    std::uint32_t at = 0;
    while (at < nodes_.size() && left != 0) {
      const Node& node = nodes_[at];
      const std::uint64_t here = within(points, node.box, left);
      if (here == 0) {
        at = node.after;
        continue;
      }
      if (node.index != kInner) left = visit(node.index, here, left);
      ++at;
    }
    return left;
  }

 private:
  static constexpr std::uint32_t kInner = 0xffffffffu;

  /// Nodes lie in the order of a walk through the tree, so the next to visit is the next in the list, or `after` when
  /// this one is missed.
  struct Node {
    Box3 box;
    std::uint32_t index = kInner;  ///< of a leaf's box
    std::uint32_t after = 0;
  };

  void build(std::span<const Box3> boxes, std::span<std::uint32_t> order);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> boundless_;
};

}  // namespace firstlight::render
