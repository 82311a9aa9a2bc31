#pragma once

#include "render/accel/float_box.h"
#include "render/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// Kinds of what hangs in a slot of a node: an inner node, a group of spheres, or one other leaf. There is room for
/// eight.
enum class ChildKind : std::uint32_t { node = 0, sphere, box, solid };

/// A kind and a number of it; the kind is in the highest bits.
struct ChildRef {
  static constexpr int kIndexBits = 29;

  std::uint32_t bits;

  static ChildRef of(ChildKind kind, std::uint32_t index) {
    return {static_cast<std::uint32_t>(kind) << kIndexBits | index};
  }
  ChildKind kind() const { return static_cast<ChildKind>(bits >> kIndexBits); }
  std::uint32_t index() const { return bits & ((std::uint32_t{1} << kIndexBits) - 1); }
};

constexpr std::size_t kTreeWidth = 8;
/// No path from the root is longer; traversal stacks are sized by it.
constexpr std::size_t kTreeDepth = 64;

/// Eight boxes side by side, in float. bounds[2 * axis] are the lower faces, bounds[2 * axis + 1] the upper; an empty
/// slot has them the wrong way round and infinite, so no ray meets it. Every face at v lies outwards of what it bounds
/// by at least kFaceRoom * |v|, which is the room that a test in float needs.
struct alignas(64) WideNode {
  static constexpr double kFaceRoom = 0x1p-21;

  float bounds[6][kTreeWidth];
  ChildRef child[kTreeWidth];
};

/// A box for the tree with what it stands for.
struct TreeItem {
  Box3 box;
  ChildRef leaf;
};

/// When a box test in float is good enough, see FloatRay.
struct FloatLimits {
  float farthest_origin = 0.0f;  ///< the largest coordinate of an origin at which the margin stays small
  float shared_margin = 0.0f;    ///< the part of the margin that all those origins share
};

/// Up to eight spheres that are tested at once, each by the index() of its TreeItem::leaf; the rest is kNoSphere.
using SphereGroup = std::array<std::uint32_t, 8>;
constexpr std::uint32_t kNoSphere = 0xffffffffu;

/// A bounding hierarchy with eight children a node. Neighbouring spheres hang in groups; of anything else there is one
/// item a leaf.
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
  /// The groups that the references to spheres in nodes() stand for.
  const std::vector<SphereGroup>& sphere_groups() const { return sphere_groups_; }
  /// The bounds of all nodes, with the same room.
  const FloatBox& bounds() const { return bounds_; }
  const FloatLimits& float_limits() const { return float_limits_; }

 private:
  std::vector<WideNode> nodes_;
  std::vector<SphereGroup> sphere_groups_;
  FloatBox bounds_;
  FloatLimits float_limits_;
  bool built_ = true;
};

}  // namespace firstlight::render
