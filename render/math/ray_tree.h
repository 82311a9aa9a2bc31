#pragma once

#include "render/math/bounds.h"
#include "render/math/vec.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// Finds among very many boxes those that a ray meets, the nearer ones first: the faces of a mesh or a landscape.
///
/// Cost     Built in O(n log n) by the surface area heuristic over kBins bins, 32 bytes a node. [Wald, On Fast
///          Construction of SAH-based Bounding Volume Hierarchies, 2007]
/// Order    Which boxes are visited, and in which order, depends on the ray and the boxes alone; a smaller `high` leaves
///          some out.
class RayTree {
 public:
  RayTree() = default;
  /// Pre: the boxes are bounded; fewer than 2^31.
  explicit RayTree(std::span<const Box3> boxes);

  /// Calls visit(index) for the boxes that the ray meets between its origin and `high`, which visit() may lower.
  template <class Visit>
  void walk(const Ray& ray, const double& high, const Visit& visit) const {
    if (nodes_.empty()) return;
    const Slabs slabs(ray);
    std::array<std::uint32_t, kDeepest + 1> waiting;
    std::size_t count = 0;
    std::uint32_t at = 0;
    for (;;) {
      const Node& node = nodes_[at];
      if (slabs.meets(node, high)) {
        if (node.count == 0) {
          const bool second_first = slabs.backwards[node.axis];
          waiting[count++] = second_first ? at + 1 : node.first;
          at = second_first ? node.first : at + 1;
          continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(order_[i]);
      }
      if (count == 0) return;
      at = waiting[--count];
    }
  }

 private:
  static constexpr std::size_t kDeepest = 64;

  struct Node {
    std::array<float, 3> low;
    std::array<float, 3> high;
    std::uint32_t first;  ///< of a leaf: into order_; else the second child, the first being the next node
    std::uint16_t count;  ///< of a leaf; else 0
    std::uint16_t axis;   ///< along which the children lie, the first one lower
  };
  struct Slabs {
    Vec3 origin;
    Vec3 inverse;
    std::array<bool, 3> backwards;

    explicit Slabs(const Ray& ray) : origin(ray.origin) {
      for (int axis = 0; axis < 3; ++axis) {
        inverse[axis] = 1.0 / ray.direction[axis];
        backwards[static_cast<std::size_t>(axis)] = std::signbit(ray.direction[axis]);
      }
    }
    /// A number that is none, of a ray in the plane of a side, decides nothing.
    bool meets(const Node& node, double far) const {
      double near = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis);
        const double enters = ((backwards[axis] ? node.high[axis] : node.low[axis]) - origin[a]) * inverse[a];
        const double leaves = ((backwards[axis] ? node.low[axis] : node.high[axis]) - origin[a]) * inverse[a];
        if (enters > near) near = enters;
        if (leaves < far) far = leaves;
      }
      return near <= far;
    }
  };

  void build(std::span<const Box3> boxes, std::size_t begin, std::size_t end, std::size_t depth);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace firstlight::render
