#pragma once

#include "render/shape/mesh.h"
#include "render/texture/texture.h"

#include <cstdint>
#include <optional>
#include <unordered_map>

namespace firstlight::parser {

/// Gathers separate triangles into a mesh with shared corners, as `mesh` gives them.
/// Cost  O(1) a triangle.
class MeshBuilder {
 public:
  struct Triangle {
    std::array<render::Vec3, 3> corners;
    std::optional<std::array<render::Vec3, 3>> normals;  ///< of a smooth one; of any length but 0
    std::optional<std::array<render::Vec2, 3>> uv;
    std::array<render::TexturePtr, 3> textures;  ///< all null: the object's
  };

  void add(const Triangle& triangle);
  std::size_t size() const { return mesh_.faces.size(); }
  const std::vector<render::TexturePtr>& textures() const { return list_; }
  /// The mesh; the builder is empty afterwards.
  render::MeshParameters take();

 private:
  struct Bits {
    std::uint64_t a = 0, b = 0;
    bool operator==(const Bits&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Bits& bits) const {
      return static_cast<std::size_t>((bits.a ^ (bits.b * 0x9e3779b97f4a7c15u)) * 0xff51afd7ed558ccdu >> 7);
    }
  };
  using Places = std::unordered_map<Bits, std::uint32_t, Hash>;

  static std::uint32_t place_of(Places& places, std::vector<Imath::V3f>& list, const render::Vec3& value);
  std::uint32_t uv_place(const render::Vec2& value);
  std::uint32_t texture_place(const render::TexturePtr& texture);

  render::MeshParameters mesh_;
  std::vector<render::TexturePtr> list_;
  Places vertices_, normals_, uvs_;
  std::unordered_map<const render::Texture*, std::uint32_t> textures_;
};

/// The entry of MeshParameters::face_normals for three unit normals: `corners`, or none where they are equal, for then the
/// face is flat.
render::MeshParameters::Corners smooth_corners(const std::array<render::Vec3, 3>& normals,
                                         const render::MeshParameters::Corners& corners);

}  // namespace firstlight::parser
