#pragma once

#include "render/math/ray_tree.h"
#include "render/shape/mesh.h"
#include "render/shape/placed.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace firstlight::render {

/// Where a ray meets a face.
struct FaceMet {
  double depth;
  std::uint32_t face;
};

/// The faces of a mesh, in its own space, and what is said about them.
///
/// Source   POV-Ray 3.7. The outline is tested in the projection along the largest component of the normal; points on
///          an edge are in. Planes are kept in single precision.
class MeshFaces {
 public:
  /// The faces of a leaf of the tree side by side, as rays ask for them. A face that is not there has no normal.
  struct alignas(64) Block {
    static constexpr std::size_t kSize = RayTree::kLeafSize;

    float normal[3][kSize];
    float offset[kSize];  ///< normal . p + offset = 0
    float u[3][kSize];    ///< of the corners, along the axes of the projection
    float v[3][kSize];
    RayTree::Leaf face;
    std::uint8_t u_is_y;  ///< bits of those of which these axes are not x and z
    std::uint8_t v_is_y;
  };

  explicit MeshFaces(MeshParameters parameters);

  const MeshParameters& parameters() const { return parameters_; }
  const Box3& bounds() const { return bounds_; }
  const RayTree& tree() const { return tree_; }
  const Block& block(std::size_t leaf) const { return blocks_[leaf]; }

  /// Appends all faces that the ray meets, in their order; `ray` is in the mesh's own space, with a direction of any
  /// length.
  void meet(const Ray& ray, std::vector<FaceMet>& out) const;
  /// Finds the nearest crossing of each ray in the window, of equal ones that of the last face; returns the bits of the
  /// rays that have one. Pre: asked.nearest_only.
  std::uint64_t meet_nearest(const RaysAndPlace& asked, Column<double>& depth, Column<double>& face) const;

  /// Not normalised further than single precision; 0 without area.
  Vec3 flat_normal(std::uint32_t index) const { return Vec3(plane_of(index).normal); }
  /// The same, interpolated where the face is a smooth one; of any length.
  Vec3 normal(const Vec3& point, std::uint32_t index) const;
  Vec2 uv(const Vec3& point, std::uint32_t index) const;
  bool has_textures() const { return !parameters_.face_textures.empty(); }
  /// At `place` of some places. `point()` is asked where the corners have different textures. Pre: has_textures().
  template <class Point>
  void textures(std::uint32_t place, const Point& point, std::uint32_t index, std::vector<TextureShare>& out) const {
    const Corners& corners = parameters_.face_textures[index];
    if (corners == MeshParameters::kNoCorners) {
      out.push_back({place, kObjectTexture, 1.0});
    } else if (corners[0] == corners[1] && corners[0] == corners[2]) {
      out.push_back({place, corners[0], 1.0});
    } else {
      const std::array<double, 3> weights = barycentric(point(), parameters_.faces[index]);
      const double sum = weights[0] + weights[1] + weights[2];
      for (std::size_t i = 0; i < 3; ++i) out.push_back({place, corners[i], weights[i] / sum});
    }
  }

 private:
  using Corners = MeshParameters::Corners;

  struct Plane {
    Imath::V3f normal{0.0f};
    float offset = 0.0f;
    std::uint8_t u = 0, v = 1;  ///< the axes of the projection in which the outline is tested
    bool swapped = false;       ///< the first two corners are exchanged
  };

  Vec3 vertex(std::uint32_t index) const { return Vec3(parameters_.vertices[index]); }
  Plane plane_of(std::uint32_t index) const;
  Block block_of(const RayTree::Leaf& leaf) const;
  std::array<double, 3> barycentric(const Vec3& point, const Corners& corners) const;

  MeshParameters parameters_;
  RayTree tree_;
  std::vector<Block> blocks_;  ///< of the tree's leaves
  Box3 bounds_;
};

}  // namespace firstlight::render
