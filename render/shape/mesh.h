#pragma once

#include "render/math/transform.h"
#include "render/shape/shape.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace firstlight::render {

/// Triangles that share their corners: `mesh` and `mesh2`.
///
/// Order    The lists by face are empty, or have an entry for each face.
/// Memory   12 bytes a face and list, 12 a corner or normal: about 30 bytes a face of a smooth closed mesh.
struct MeshParameters {
  using Corners = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr Corners kNoCorners{kNone, kNone, kNone};

  std::vector<Imath::V3f> vertices;  ///< POV-Ray keeps single precision too
  std::vector<Imath::V3f> normals;   ///< of unit length
  std::vector<Vec2> uv;
  std::vector<Corners> faces;         ///< into `vertices`
  std::vector<Corners> face_normals;  ///< into `normals`; kNoCorners: a flat face
  std::vector<Corners> face_uvs;      ///< into `uv`; without, all corners are at (0, 0)
  /// Into the shape's list of textures, interpolated between the corners; kNoCorners: the object's texture.
  std::vector<Corners> face_textures;
  /// Unit vector: a point is inside if a ray this way leaves the mesh once more than it enters. Without, the mesh has
  /// no inside.
  std::optional<Vec3> inside_vector;
};

/// Faces without area are left out.
/// Cost     O(n log n), and some 80 bytes a face beside the parameters.
ShapePtr make_mesh(MeshParameters parameters);
/// The parameters that a mesh was made of; null for any other shape.
const MeshParameters* mesh_of(const Shape& shape);

// ---- For a camera that sits on a mesh. Pre of all: mesh_of(mesh) is not null.

/// From the space of the parameters to that of the scene.
const Transform& mesh_placement(const Shape& mesh);
/// The normal of the flat face, in the space of the parameters; not normalised further than single precision; 0 without
/// area.
Vec3 flat_normal(const Shape& mesh, std::uint32_t face);
/// The same, interpolated where the face is a smooth one; of any length.
Vec3 smooth_normal(const Shape& mesh, const Vec3& point, std::uint32_t face);

}  // namespace firstlight::render
