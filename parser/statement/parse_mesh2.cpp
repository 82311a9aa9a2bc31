// `mesh2`: lists of corners, normals and textures, and triangles as indices into them.
#include "parser/statement/parse_mesh2.h"

#include "parser/statement/mesh_builder.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <unordered_set>

namespace firstlight::parser {

using render::MeshParameters;
using render::Object;
using render::Vec3;
using Corners = MeshParameters::Corners;

namespace {

/// How many entries follow in the block that `word` opens.
std::size_t parse_count(Reader& reader, const Token& word) {
  const Token& at = reader.peek();
  const double count = finite_number(reader, "count in " + quoted(word));
  reader.skip_comma();
  if (count > static_cast<double>(kMostFaces)) {
    reader.fail(at, fmt::format("{} has more than {} entries", quoted(word), kMostFaces));
  }
  return count < 1.0 ? 0 : static_cast<std::size_t>(count);
}

/// Three places in a list of `size`.
Corners parse_corners(Reader& reader, const Token& word, std::size_t size) {
  const Token& at = reader.peek();
  const Vec3 places = finite_vector(reader, "index in " + quoted(word));
  reader.skip_comma();
  Corners corners;
  for (int i = 0; i < 3; ++i) {
    if (places[i] <= -1.0 || places[i] >= static_cast<double>(size)) {
      reader.fail(at, fmt::format("index {} in {} is out of range: there are {}", places[i], quoted(word), size));
    }
    corners[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(std::max(places[i], 0.0));
  }
  return corners;
}

/// A `mesh2` under way.
class Mesh2 {
 public:
  Mesh2(Reader& reader, SceneContext& context, const Token& word) : reader_(reader), context_(context), word_(word) {}

  MeshParameters parse() {
    while (accept_list()) {
    }
    if (mesh_.vertices.empty()) reader_.fail(word_, "'mesh2' needs 'vertex_vectors'");
    parse_faces();
    while (reader_.next_is(Keyword::uv_indices) || reader_.next_is(Keyword::normal_indices)) {
      if (reader_.next_is(Keyword::uv_indices)) {
        parse_uv_indices();
      } else {
        parse_normal_indices();
      }
    }
    while (reader_.accept(Keyword::inside_vector)) mesh_.inside_vector = parse_inside_vector(reader_);
    complete_uvs();
    complete_normals();
    return std::move(mesh_);
  }
  const std::vector<render::TexturePtr>& textures() const { return textures_; }

 private:
  bool accept_list() {
    if (texture_list_seen_) return false;
    const Token& word = reader_.peek();
    if (reader_.accept(Keyword::vertex_vectors)) {
      parse_vertices(word);
    } else if (reader_.accept(Keyword::normal_vectors)) {
      parse_normals(word);
    } else if (reader_.accept(Keyword::uv_vectors)) {
      parse_uvs(word);
    } else if (reader_.accept(Keyword::texture_list)) {
      parse_textures(word);
    } else {
      return false;
    }
    return true;
  }

  template <class List>
  void restart(const Token& word, List& list) {
    if (!list.empty()) reader_.warn(word, quoted(word) + " was given before; only this one counts");
    list.clear();
  }

  static Imath::V3f rounded(const Vec3& value) {
    return {static_cast<float>(value.x), static_cast<float>(value.y), static_cast<float>(value.z)};
  }

  void parse_vertices(const Token& word) {
    restart(word, mesh_.vertices);
    reader_.open_block(word);
    const std::size_t count = parse_count(reader_, word);
    if (count == 0) reader_.fail(word, "'mesh2' has no corners");
    endless_.clear();
    while (mesh_.vertices.size() < count) {
      const Token& at = reader_.peek();
      Imath::V3f corner = rounded(reader_.vector3());
      if (!is_finite(Vec3(corner))) {
        if (endless_.empty()) reader_.warn(at, "this corner is not finite, so nothing is seen of its triangles");
        endless_.insert(static_cast<std::uint32_t>(mesh_.vertices.size()));
        corner = Imath::V3f(0.0f);
      }
      mesh_.vertices.push_back(corner);
      reader_.skip_comma();
    }
    reader_.close_block();
  }

  void parse_normals(const Token& word) {
    restart(word, mesh_.normals);
    reader_.open_block(word);
    const std::size_t count = parse_count(reader_, word);
    while (mesh_.normals.size() < count) {
      const Vec3 normal = parse_mesh_normal(reader_, warned_);
      mesh_.normals.push_back(rounded(normal / normal.length()));
      reader_.skip_comma();
    }
    reader_.close_block();
  }

  void parse_uvs(const Token& word) {
    restart(word, mesh_.uv);
    reader_.open_block(word);
    const std::size_t count = parse_count(reader_, word);
    while (mesh_.uv.size() < count) {
      mesh_.uv.push_back(finite_vector2(reader_, "uv_vectors"));
      reader_.skip_comma();
    }
    reader_.close_block();
  }

  void parse_textures(const Token& word) {
    texture_list_seen_ = true;
    reader_.open_block(word);
    const std::size_t count = parse_count(reader_, word);
    while (textures_.size() < count) {
      const Token& texture = reader_.peek();
      if (!reader_.accept(Keyword::texture)) reader_.fail_expected("'texture'");
      textures_.push_back(parse_texture(reader_, context_, texture));
      reader_.skip_comma();
    }
    reader_.close_block();
  }

  /// One to three places in the list of textures behind a face; the later ones of the second and third corner.
  void parse_face_textures(const Token& word) {
    Corners textures = MeshParameters::kNoCorners;
    std::size_t given = 0;
    while (given < 3 && reader_.at_number()) {
      const Token& at = reader_.peek();
      const int place = integer(reader_, "texture index");
      reader_.skip_comma();
      if (place < 0 || static_cast<std::size_t>(place) >= textures_.size()) {
        reader_.fail(
            at, fmt::format("texture {} in {} is out of range: there are {}", place, quoted(word), textures_.size()));
      }
      textures[given++] = static_cast<std::uint32_t>(place);
    }
    if (given < 3) textures[2] = textures[1] = textures[0];  // two are one [POV-Ray 3.7]
    if (given == 0 && mesh_.face_textures.empty()) return;
    mesh_.face_textures.resize(mesh_.faces.size() - 1, MeshParameters::kNoCorners);
    mesh_.face_textures.push_back(textures);
  }

  void parse_faces() {
    const Token& word = reader_.peek();
    if (!reader_.accept(Keyword::face_indices)) reader_.fail_expected("'face_indices'");
    reader_.open_block(word);
    const std::size_t count = parse_count(reader_, word);
    if (count == 0) reader_.fail(word, "'mesh2' has no triangles");
    while (mesh_.faces.size() < count) {
      Corners& corners = mesh_.faces.emplace_back(parse_corners(reader_, word, mesh_.vertices.size()));
      // A triangle without an end is not seen; one without a size stands for it in the lists. [POV-Ray 3.7]
      const bool ends = std::ranges::none_of(corners, [&](std::uint32_t corner) { return endless_.contains(corner); });
      if (!ends) corners.fill(corners[0]);
      parse_face_textures(word);
    }
    reader_.close_block();
  }

  void parse_uv_indices() {
    const Token& word = reader_.take();
    if (!mesh_.face_uvs.empty()) reader_.fail(word, "'mesh2' can have 'uv_indices' only once");
    reader_.open_block(word);
    if (parse_count(reader_, word) != mesh_.faces.size()) {
      reader_.fail(word,
                   fmt::format("'uv_indices' must have as many entries as 'face_indices': {}", mesh_.faces.size()));
    }
    const std::size_t size = std::max<std::size_t>(mesh_.uv.size(), 1);
    while (mesh_.face_uvs.size() < mesh_.faces.size()) {
      mesh_.face_uvs.push_back(parse_corners(reader_, word, size));
    }
    reader_.close_block();
  }

  void parse_normal_indices() {
    const Token& word = reader_.take();
    if (normal_indices_seen_) reader_.fail(word, "'mesh2' can have 'normal_indices' only once");
    normal_indices_seen_ = true;
    reader_.open_block(word);
    const std::size_t count = parse_count(reader_, word);
    if (count > mesh_.faces.size()) {
      reader_.fail(word, fmt::format("'normal_indices' has more entries than there are faces: {}", mesh_.faces.size()));
    }
    while (mesh_.face_normals.size() < count) add_normals(parse_corners(reader_, word, mesh_.normals.size()));
    reader_.close_block();
  }

  void add_normals(const Corners& corners) {
    const auto normal = [&](std::size_t i) { return Vec3(mesh_.normals[corners[i]]); };
    mesh_.face_normals.push_back(smooth_corners({normal(0), normal(1), normal(2)}, corners));
  }

  /// Without indices of their own, texture coordinates go with the corners.
  void complete_uvs() {
    if (!mesh_.face_uvs.empty()) {
      if (mesh_.uv.empty()) mesh_.uv.emplace_back(0.0, 0.0);
      return;
    }
    if (mesh_.uv.size() == mesh_.vertices.size()) {
      mesh_.face_uvs = mesh_.faces;
    } else if (mesh_.uv.size() == 1) {
      mesh_.face_uvs.assign(mesh_.faces.size(), Corners{0, 0, 0});
    } else if (!mesh_.uv.empty()) {
      reader_.fail(word_, "'mesh2' needs 'uv_indices', for there are not as many 'uv_vectors' as 'vertex_vectors'");
    }
  }

  void complete_normals() {
    if (!normal_indices_seen_ && mesh_.normals.size() == mesh_.vertices.size()) {
      for (const Corners& face : mesh_.faces) add_normals(face);
    } else if (!normal_indices_seen_ && !mesh_.normals.empty()) {
      reader_.fail(word_,
                   "'mesh2' needs 'normal_indices', for there are not as many 'normal_vectors' as 'vertex_vectors'");
    }
    // faces behind the last entry are flat
    if (!mesh_.face_normals.empty()) mesh_.face_normals.resize(mesh_.faces.size(), MeshParameters::kNoCorners);
    if (!mesh_.face_textures.empty()) mesh_.face_textures.resize(mesh_.faces.size(), MeshParameters::kNoCorners);
  }

  Reader& reader_;
  SceneContext& context_;
  const Token& word_;
  MeshParameters mesh_;
  std::vector<render::TexturePtr> textures_;
  std::unordered_set<std::uint32_t> endless_;  ///< corners that are not finite
  bool texture_list_seen_ = false;
  bool normal_indices_seen_ = false;
  bool warned_ = false;
};

}  // namespace

void parse_mesh2(Reader& reader, SceneContext& context, const Token& word, Object& object) {
  Mesh2 mesh2(reader, context, word);
  render::MeshParameters mesh = mesh2.parse();
  if (!mesh2.textures().empty()) object.extras.change().shape_textures = mesh2.textures();
  object.patch = !mesh.inside_vector;
  object.shape = render::make_mesh(std::move(mesh));
}

}  // namespace firstlight::parser
