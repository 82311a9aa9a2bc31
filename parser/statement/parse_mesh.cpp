// `mesh`: triangles one by one.
#include "parser/statement/mesh_builder.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_mesh2.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace firstlight::parser {

using render::Object;
using render::TexturePtr;
using render::Vec3;
using Triangle = MeshBuilder::Triangle;

namespace {

TexturePtr declared_texture(Reader& reader) {
  TexturePtr texture = reader.accept_declared<render::Texture>();
  if (!texture) reader.fail_expected("a declared texture");
  return texture;
}

/// `texture { T }`, or `texture_list { T1 T2 T3 }` for the three corners.
void parse_triangle_textures(Reader& reader, Triangle& triangle) {
  for (;;) {
    const Token& word = reader.peek();
    if (reader.accept(Keyword::texture)) {
      reader.open_block(word);
      triangle.textures.fill(declared_texture(reader));
      reader.close_block();
    } else if (reader.accept(Keyword::texture_list)) {
      reader.open_block(word);
      for (TexturePtr& texture : triangle.textures) {
        texture = declared_texture(reader);
        reader.skip_comma();
      }
      reader.close_block();
      return;
    } else {
      return;
    }
  }
}

/// Parses what follows the corners of a triangle, and its `}`.
void parse_triangle_end(Reader& reader, Triangle& triangle) {
  if (reader.accept(Keyword::uv_vectors)) {
    triangle.uv.emplace();
    for (render::Vec2& uv : *triangle.uv) {
      uv = finite_vector2(reader, "uv_vectors");
      if (&uv != &triangle.uv->back()) reader.skip_comma();
    }
  }
  parse_triangle_textures(reader, triangle);
  reader.close_block();
}

Triangle parse_flat_triangle(Reader& reader, const Token& word) {
  Triangle triangle;
  reader.open_block(word);
  for (Vec3& corner : triangle.corners) {
    corner = reader.vector3();
    if (&corner != &triangle.corners.back()) reader.skip_comma();
  }
  parse_triangle_end(reader, triangle);
  return triangle;
}

Triangle parse_smooth_triangle_of_mesh(Reader& reader, const Token& word, bool& warned) {
  Triangle triangle;
  triangle.normals.emplace();
  reader.open_block(word);
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.corners[i] = reader.vector3();
    reader.skip_comma();
    (*triangle.normals)[i] = parse_mesh_normal(reader, warned);
    if (i < 2) reader.skip_comma();
  }
  parse_triangle_end(reader, triangle);
  return triangle;
}

/// False for one without an end, too: nothing is seen of it. [POV-Ray 3.7]
bool has_area(const std::array<Vec3, 3>& corners) {
  const double area = (corners[0] - corners[1]).cross(corners[2] - corners[1]).length();
  return std::isfinite(area) && area != 0.0;
}

}  // namespace

Vec3 parse_mesh_normal(Reader& reader, bool& warned) {
  const Token& at = reader.peek();
  const Vec3 normal = finite_vector(reader, "normal of a mesh");
  if (!same_point(normal, Vec3(0.0))) return normal;
  if (!warned) reader.warn(at, "a normal of a mesh is zero; it is taken as <1, 0, 0>");
  warned = true;
  return {1.0, normal.y, normal.z};
}

std::optional<Vec3> parse_inside_vector(Reader& reader) {
  const Vec3 direction = finite_vector(reader, "inside_vector");
  if (same_point(direction, Vec3(0.0))) return std::nullopt;
  return direction / direction.length();
}

void parse_mesh(Reader& reader, SceneContext&, const Token& word, Object& object) {
  MeshBuilder builder;
  std::optional<Vec3> inside_vector;
  bool warned = false;
  for (;;) {
    const Token& next = reader.peek();
    Triangle triangle;
    if (reader.accept(Keyword::triangle)) {
      triangle = parse_flat_triangle(reader, next);
    } else if (reader.accept(Keyword::smooth_triangle)) {
      triangle = parse_smooth_triangle_of_mesh(reader, next, warned);
    } else if (reader.accept(Keyword::inside_vector)) {
      inside_vector = parse_inside_vector(reader);
      continue;
    } else {
      break;
    }
    if (has_area(triangle.corners)) {
      builder.add(triangle);
    } else if (!std::ranges::all_of(triangle.corners, is_finite)) {
      reader.warn(next, "a corner of this triangle is not finite, so nothing is seen of it");
    }
    if (builder.size() > kMostFaces)
      reader.fail(next, "'mesh' has more than " + std::to_string(kMostFaces) + " triangles");
  }
  if (builder.size() == 0) reader.fail(word, "'mesh' has no triangles");
  if (!builder.textures().empty()) object.extras.change().shape_textures = builder.textures();
  render::MeshParameters mesh = builder.take();
  mesh.inside_vector = inside_vector;
  object.patch = !inside_vector;
  object.shape = render::make_mesh(std::move(mesh));
}

}  // namespace firstlight::parser
