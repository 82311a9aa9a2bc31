#include "parser/statement/mesh_builder.h"

#include "parser/statement/parse_common.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace firstlight::parser {

using render::MeshParameters;
using render::Vec2;
using render::Vec3;
using Corners = MeshParameters::Corners;

namespace {

std::uint64_t pair_of(float high, float low) {
  return static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(high)) << 32 | std::bit_cast<std::uint32_t>(low);
}

}  // namespace

std::uint32_t MeshBuilder::place_of(Places& places, std::vector<Imath::V3f>& list, const Vec3& value) {
  // + 0.0f makes one of the two zeros
  const Imath::V3f rounded(static_cast<float>(value.x) + 0.0f, static_cast<float>(value.y) + 0.0f,
                           static_cast<float>(value.z) + 0.0f);
  const Bits bits{pair_of(rounded.x, rounded.y), pair_of(0.0f, rounded.z)};
  const auto [entry, is_new] = places.try_emplace(bits, static_cast<std::uint32_t>(list.size()));
  if (is_new) list.push_back(rounded);
  return entry->second;
}

std::uint32_t MeshBuilder::uv_place(const Vec2& value) {
  const Bits bits{std::bit_cast<std::uint64_t>(value.x + 0.0), std::bit_cast<std::uint64_t>(value.y + 0.0)};
  const auto [entry, is_new] = uvs_.try_emplace(bits, static_cast<std::uint32_t>(mesh_.uv.size()));
  if (is_new) mesh_.uv.push_back(value);
  return entry->second;
}

std::uint32_t MeshBuilder::texture_place(const render::TexturePtr& texture) {
  if (!texture) return MeshParameters::kNone;
  const auto [entry, is_new] = textures_.try_emplace(texture.get(), static_cast<std::uint32_t>(list_.size()));
  if (is_new) list_.push_back(texture);
  return entry->second;
}

void MeshBuilder::add(const Triangle& triangle) {
  // A list by face begins when the first face needs it; the faces before have the default.
  const std::size_t face = mesh_.faces.size();
  Corners corners;
  for (int i = 0; i < 3; ++i) corners[i] = place_of(vertices_, mesh_.vertices, triangle.corners[i]);
  mesh_.faces.push_back(corners);
  if (triangle.normals) {
    std::array<Vec3, 3> unit;
    std::transform(triangle.normals->begin(), triangle.normals->end(), unit.begin(),
                   [](const Vec3& normal) { return normal / normal.length(); });
    if (smooth_corners(unit, {}) != MeshParameters::kNoCorners) {
      for (int i = 0; i < 3; ++i) corners[i] = place_of(normals_, mesh_.normals, unit[i]);
      mesh_.face_normals.resize(face, MeshParameters::kNoCorners);
      mesh_.face_normals.push_back(corners);
    }
  }
  if (triangle.uv || !mesh_.face_uvs.empty()) {
    if (mesh_.face_uvs.size() < face) {
      const std::uint32_t origin = uv_place(Vec2(0.0, 0.0));
      mesh_.face_uvs.resize(face, Corners{origin, origin, origin});
    }
    for (int i = 0; i < 3; ++i) corners[i] = uv_place(triangle.uv ? (*triangle.uv)[i] : Vec2(0.0, 0.0));
    mesh_.face_uvs.push_back(corners);
  }
  if (triangle.textures[0]) {
    for (int i = 0; i < 3; ++i) corners[i] = texture_place(triangle.textures[i]);
    mesh_.face_textures.resize(face, MeshParameters::kNoCorners);
    mesh_.face_textures.push_back(corners);
  }
}

MeshParameters MeshBuilder::take() {
  const std::size_t faces = mesh_.faces.size();
  if (!mesh_.face_normals.empty()) mesh_.face_normals.resize(faces, MeshParameters::kNoCorners);
  if (!mesh_.face_textures.empty()) mesh_.face_textures.resize(faces, MeshParameters::kNoCorners);
  MeshParameters mesh = std::move(mesh_);
  *this = MeshBuilder();
  return mesh;
}

Corners smooth_corners(const std::array<Vec3, 3>& normals, const Corners& corners) {
  const bool flat =
      (normals[0] - normals[1]).length2() <= kTinyLength && (normals[0] - normals[2]).length2() <= kTinyLength;
  return flat ? MeshParameters::kNoCorners : corners;
}

}  // namespace firstlight::parser
