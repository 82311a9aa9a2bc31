#pragma once

#include "render/math/ray_columns.h"
#include "render/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// Finds among very many boxes those that a ray meets, the nearer ones first: the faces of a mesh or a patch. How rays
/// go through it is in render/math/ray_tree-inl.h.
///
/// Cost     Built in O(n log n) by the surface area heuristic over bins, some 10 bytes a box in the end. [Wald, On Fast
///          Construction of SAH-based Bounding Volume Hierarchies, 2007]
/// Order    Which boxes are visited, and in which order, depends on the ray and the boxes alone; a smaller depth up to
///          which it looks leaves some out.
class RayTree {
 public:
  static constexpr std::size_t kWidth = 8;     ///< the most children of a node
  static constexpr std::size_t kLeafSize = 8;  ///< the most boxes of a leaf
  static constexpr std::size_t kDeepest = 64;  ///< no path to a leaf has more nodes
  static constexpr std::uint32_t kNone = 0xffffffffu;

  struct Item {
    Imath::Box3f box;
    std::uint32_t number;
  };

  /// A node or a leaf by its number.
  struct Child {
    std::uint32_t bits;

    static Child node(std::size_t number) { return {static_cast<std::uint32_t>(number)}; }
    static Child leaf(std::size_t number) { return {static_cast<std::uint32_t>(number) | kLeafBit}; }
    bool is_leaf() const { return (bits & kLeafBit) != 0; }
    std::uint32_t number() const { return bits & ~kLeafBit; }

   private:
    static constexpr std::uint32_t kLeafBit = 0x80000000u;
  };
  /// Eight boxes side by side, beside the tree's middle and with some room. bounds[2 * axis] are the lower faces,
  /// bounds[2 * axis + 1] the upper.
  struct alignas(64) Node {
    float bounds[6][kWidth];
    Child child[kWidth];
    /// By octants of rays, in whose numbers bit `axis` is set of those that go down along it: the children in the order
    /// in which such rays come to them, the first in the lowest three bits. From kCountShift on: how many there are.
    std::uint32_t order[8];

    static constexpr unsigned kCountShift = 24;
    std::size_t count() const { return order[0] >> kCountShift; }
    std::size_t nth(unsigned octant, std::size_t n) const { return order[octant] >> 3 * n & 7; }
  };
  /// The numbers of a leaf's boxes; behind the last kNone.
  using Leaf = std::array<std::uint32_t, kLeafSize>;

  RayTree() = default;
  /// Pre: the boxes are bounded; fewer than 2^31.
  explicit RayTree(std::vector<Item> items);
  /// Leaves of at most so many: few where what is in a box is not met together.
  RayTree(std::span<const Box3> boxes, std::size_t leaf_size);

  /// A box that a ray of a block meets.
  struct Found {
    std::uint32_t ray;
    std::uint32_t box;
  };
  /// Appends the boxes that rays in `who` meet between their origin and `high`; those of one ray in the order in which it
  /// alone finds them.
  void find(const RayColumns& rays, std::uint64_t who, const Column<double>& high, std::vector<Found>& out) const;
  /// The same of one ray.
  void find(const Ray& ray, double high, std::vector<Found>& out) const;

  /// The root is the first; none of a tree of nothing.
  std::span<const Node> nodes() const { return nodes_; }
  std::span<const Leaf> leaves() const { return leaves_; }
  const Vec3& middle() const { return middle_; }
  /// Half the size of what all boxes are within, room included.
  const Vec3& reach() const { return reach_; }

 private:
  struct Part;

  void build(std::span<Item> items);
  void add_node(std::span<Item> items, const Part& whole);
  Child add_leaf(std::span<const Item> items);
  Imath::Box3f with_room(const Imath::Box3f& box) const;

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  Vec3 middle_{0.0};
  Vec3 reach_{0.0};
  double room_ = 0.0;
  std::size_t leaf_size_ = kLeafSize;
};

}  // namespace firstlight::render
