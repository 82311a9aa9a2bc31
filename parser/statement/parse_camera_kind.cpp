#include "parser/statement/parse_camera_kind.h"

#include "parser/statement/parse_common.h"
#include "parser/statement/parse_object.h"
#include "render/shape/mesh.h"

#include <algorithm>
#include <array>
#include <utility>

namespace firstlight::parser {

using render::CameraKind;
using render::MeshCamera;

namespace {

struct Row {
  Keyword word;
  CameraKind kind;
};

/// The first row counts of cylinders, that of type 1; the others follow it.
constexpr auto kRows = std::to_array<Row>({
#define CAMERA(kind, word, maker) {Keyword::word, CameraKind::kind},
#include "render/camera/cameras.def"
#undef CAMERA
});

const Row* find_row(const Token& word) {
  if (word.kind != TokenKind::keyword) return nullptr;
  const auto row = std::ranges::find(kRows, word.keyword, &Row::word);
  return row == kRows.end() ? nullptr : &*row;
}

CameraKind parse_cylinder_type(Reader& reader) {
  const Token& at = reader.peek();
  const int type = integer(reader, "type of 'cylinder'");
  if (type < 1 || type > 4) reader.fail(at, "the type of a 'cylinder' camera must be 1, 2, 3 or 4");
  return static_cast<CameraKind>(static_cast<int>(CameraKind::cylinder_1) + type - 1);
}

std::vector<render::ShapePtr> parse_meshes(Reader& reader, SceneContext& context) {
  std::vector<render::ShapePtr> meshes;
  while (reader.next_is(Keyword::mesh) || reader.next_is(Keyword::mesh2)) {
    const Token& at = reader.peek();
    const auto mesh = parse_object(reader, context);
    const bool is_mesh = mesh && mesh->shape && render::mesh_of(*mesh->shape) != nullptr;
    if (!is_mesh) reader.fail(at, "expected a mesh here");
    meshes.push_back(mesh->shape->placed(mesh->placement));
  }
  if (meshes.empty()) reader.fail_expected("'mesh' or 'mesh2'");
  return meshes;
}

MeshCamera parse_mesh_camera(Reader& reader, SceneContext& context, const Token& word) {
  if (language_version(reader) < 350) reader.fail(word, "'mesh_camera' needs language version 3.5 or later");
  MeshCamera camera;
  reader.open_block(word);
  camera.rays_per_pixel = integer(reader, "rays per pixel");
  if (camera.rays_per_pixel < 1) reader.fail(word, "a 'mesh_camera' needs at least one ray per pixel");
  camera.distribution = integer(reader, "distribution method");
  if (camera.distribution < 0 || camera.distribution > 3) {
    reader.fail(word, "the distribution method of a 'mesh_camera' must be 0, 1, 2 or 3");
  }
  if (camera.distribution >= 2 && camera.rays_per_pixel != 1) {
    reader.fail(word, "distribution methods 2 and 3 of a 'mesh_camera' take one ray per pixel");
  }
  camera.max_ray_distance = reader.optional_number(0.0);
  camera.meshes = parse_meshes(reader, context);
  camera.smooth = reader.accept(Keyword::smooth);
  if (camera.smooth && camera.distribution != 3) {
    reader.fail(word, "'smooth' goes with distribution method 3 of a 'mesh_camera' only");
  }
  reader.close_block();
  if (camera.distribution == 0 && static_cast<std::size_t>(camera.rays_per_pixel) > camera.meshes.size()) {
    reader.fail(word, "distribution method 0 of a 'mesh_camera' needs a mesh for each ray per pixel");
  }
  if (camera.distribution == 3 && camera.meshes.size() > 1) {
    reader.warn(word, "distribution method 3 of a 'mesh_camera' uses its first mesh only");
  }
  return camera;
}

}  // namespace

std::optional<CameraKind> accept_camera_kind(Reader& reader, SceneContext& context, MeshCamera& mesh) {
  const Row* row = find_row(reader.peek());
  if (row == nullptr) return std::nullopt;
  const Token& word = reader.take();
  if (row->kind == CameraKind::cylinder_1) return parse_cylinder_type(reader);
  if (row->kind == CameraKind::mesh) mesh = parse_mesh_camera(reader, context, word);
  return row->kind;
}

bool names_camera_kind(const Token& word) { return find_row(word) != nullptr; }

}  // namespace firstlight::parser
