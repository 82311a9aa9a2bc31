#pragma once

#include "render/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// What hangs in a slot of a node: an inner node or one leaf, told apart by the two highest bits.
enum class ChildKind : std::uint32_t { node = 0, sphere = 1, box = 2, solid = 3 };

struct ChildRef {
  std::uint32_t bits;

  static ChildRef of(ChildKind kind, std::uint32_t index) { return {static_cast<std::uint32_t>(kind) << 30 | index}; }
  ChildKind kind() const { return static_cast<ChildKind>(bits >> 30); }
  std::uint32_t index() const { return bits & 0x3fffffffu; }
};

constexpr std::size_t kTreeWidth = 8;
/// No path from the root is longer; traversal stacks are sized by it.
constexpr std::size_t kTreeDepth = 64;

/// Eight boxes side by side, in float and rounded outwards. bounds[2 * axis] are the lower faces, bounds[2 * axis + 1]
/// the upper; an empty slot has them the wrong way round and infinite, so no ray meets it.
struct alignas(64) WideNode {
  float bounds[6][kTreeWidth];
  ChildRef child[kTreeWidth];
};

/// A box for the tree with what it stands for.
struct TreeItem {
  Box3 box;
  ChildRef leaf;
};

/// A bounding hierarchy with eight children a node and one item a leaf, so the box beside a leaf is the item's own.
///
/// Cost     built by Embree's binned surface-area builder, O(n log n).
/// Source   [Wald et al., Embree: A Kernel Framework for Efficient CPU Ray Tracing, 2014] for the builder.
class WideTree {
 public:
  /// Whether a box can be put into a tree: finite, and not so large that its area overflows a float.
  static bool fits(const Box3& box);

  WideTree() = default;
  /// Pre: every box fits and is not empty. False from built() afterwards: the builder could not be had.
  explicit WideTree(std::span<const TreeItem> items);

  bool built() const { return built_; }
  /// The root is the first; none for an empty tree.
  const std::vector<WideNode>& nodes() const { return nodes_; }

 private:
  std::vector<WideNode> nodes_;
  bool built_ = true;
};

}  // namespace firstlight::render
