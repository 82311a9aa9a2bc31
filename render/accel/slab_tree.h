#pragma once

#include "render/scene/extent.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// The tree of boxes in which POV-Ray 3.7 finds what a ray may meet, the same to the last node: rays that enter boxes
/// at equal depths meet what is in them in an order that follows from it.
///
/// Source   The splitting rule weighs the boxes' surfaces [Goldsmith and Salmon, Automatic Creation of Object
///          Hierarchies for Ray Tracing, 1987] over a list sorted along one axis; what is split off in one round is
///          grouped in the next.
/// Cost     O(n log^2 n) for most scenes.
class SlabTree {
 public:
  struct Node {
    Extent extent;
    bool unbounded = false;   ///< met by every ray, before all that is not
    std::uint32_t first = 0;  ///< of children(); of a leaf: the index of its extent
    std::uint32_t count = 0;  ///< 0: a leaf
  };

  /// Pre: `extents` has at least one, in the order of the scene text.
  explicit SlabTree(std::span<const Extent> extents);

  std::uint32_t root() const { return root_; }
  const Node& node(std::uint32_t number) const { return nodes_[number]; }
  std::span<const std::uint32_t> children(const Node& node) const {
    return std::span(children_).subspan(node.first, node.count);
  }

 private:
  void group(std::span<const std::uint32_t> members);
  void add_unbounded(std::span<const std::uint32_t> unbounded);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> children_;
  std::uint32_t root_ = 0;
};

}  // namespace firstlight::render
