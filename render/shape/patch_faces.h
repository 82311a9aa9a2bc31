#pragma once

#include "render/math/ray_columns.h"
#include "render/math/ray_tree.h"
#include "render/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace firstlight::render {

/// The flat pieces of a bicubic patch. Each is two triangles: face 2 n has the corners 0, 1, 2 of piece n, and face
/// 2 n + 1 the corners 0, 2, 3.
///
/// Source   POV-Ray 3.7's tolerances: triangles with no area, rays along one and crossings nearer than 1e-5 do not
///          count.
class PatchFaces {
 public:
  using Corners = std::array<Vec3, 4>;

  /// A triangle as rays ask for it, without the corner that the two of a piece have in common.
  struct Triangle {
    std::array<Vec3, 3> row{Vec3(0.0), Vec3(0.0), Vec3(0.0)};  ///< along its normal, and to the shares `a` and `b`
    double determinant = 1.0;

    /// Between that corner and two others; with no normal if it has no area.
    Triangle(const Vec3& common, const Vec3& p1, const Vec3& p2);
  };
  /// The pieces of a leaf of the tree side by side. One that is not there has no normals.
  struct alignas(64) Block {
    static constexpr std::size_t kSize = RayTree::kLeafSize;
    struct Triangles {
      double row[3][3][kSize];  ///< Triangle::row; the second index is the axis
      double determinant[kSize];
    };

    double common[3][kSize];
    Triangles triangles[2];
    RayTree::Leaf piece;
  };
  /// Where a ray of a block meets a triangle: shares of the corners but the first.
  struct Met {
    std::uint32_t ray;
    std::uint32_t face;
    double depth;
    double a, b;
  };

  PatchFaces() = default;
  explicit PatchFaces(const std::vector<Corners>& pieces);

  const RayTree& tree() const { return tree_; }
  const Block& block(std::size_t leaf) const { return blocks_[leaf]; }

  /// Appends what those rays in `who` meet, each of them in the order in which it alone does; some of what lies beyond
  /// `high` may be left out.
  void meet(const RayColumns& rays, std::uint64_t who, const Column<double>& high, std::vector<Met>& out) const;
  /// The same of a ray and a piece that is not among them.
  static void meet(const Corners& piece, const Ray& ray, std::uint32_t number, std::vector<Met>& out);

 private:
  static Block block_of(const RayTree::Leaf& leaf, const std::vector<Corners>& pieces);

  RayTree tree_;
  std::vector<Block> blocks_;  ///< of the tree's leaves
};

}  // namespace firstlight::render
