#include "render/shape/mesh.h"
#include "tests/parser/object_text.h"

namespace firstlight::parser {
namespace {

using render::MeshParameters;
using render::Vec2;
using render::Vec3;
using Corners = MeshParameters::Corners;

const std::string kTextures =
    "#declare A = texture { pigment { color rgb 1 } } #declare B = texture { pigment { color rgb 0 } } "
    "#declare C = texture { pigment { color rgb x } } ";
const std::string kVertices = "vertex_vectors { 4, 0, x, y, z } ";

MeshParameters mesh_text(const std::string& text) {
  const render::Object object = object_of(text);
  const MeshParameters* mesh = object.shape ? mesh_of(*object.shape) : nullptr;
  EXPECT_TRUE(mesh) << text;
  return mesh != nullptr ? *mesh : MeshParameters();
}

TEST(ParseMesh, TrianglesShareTheirCorners) {
  const auto mesh = mesh_text("mesh { triangle { 0, x, y } triangle { y, x, x + y } hierarchy on }");
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.faces, (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_TRUE(mesh.face_normals.empty());
  EXPECT_TRUE(mesh.face_uvs.empty());
  EXPECT_TRUE(mesh.face_textures.empty());
}

TEST(ParseMesh, SmoothTrianglesHaveUnitNormals) {
  const auto mesh = mesh_text(
      "mesh { triangle { 0, x, y } smooth_triangle { 0, 2*z, x, z + x, y, 3*z } smooth_triangle { 0, z, x, z, y, z } "
      "}");
  ASSERT_EQ(mesh.face_normals.size(), 3u);
  EXPECT_EQ(mesh.face_normals[0], MeshParameters::kNoCorners);
  EXPECT_EQ(mesh.face_normals[1], (Corners{0, 1, 0}));
  EXPECT_EQ(mesh.normals[0], Imath::V3f(0, 0, 1));
  EXPECT_EQ(mesh.face_normals[2], MeshParameters::kNoCorners) << "equal normals make a flat face";
}

TEST(ParseMesh, TrianglesMayHaveTexturesAndTextureCoordinates) {
  const auto mesh =
      mesh_text(kTextures +
                        "mesh { triangle { 0, x, y } triangle { 0, x, z texture { A } } "
                        "triangle { 0, y, z uv_vectors <0, 0>, <1, 0>, <1, 1> texture_list { A B C } } }");
  EXPECT_EQ(mesh.face_textures, (std::vector<Corners>{MeshParameters::kNoCorners, {0, 0, 0}, {0, 1, 2}}));
  ASSERT_EQ(mesh.face_uvs.size(), 3u);
  EXPECT_EQ(mesh.uv[mesh.face_uvs[2][2]], Vec2(1, 1));
  EXPECT_EQ(mesh.uv[mesh.face_uvs[0][2]], Vec2(0, 0));
}

TEST(ParseMesh, InsideVectorMakesItASolid) {
  const render::Object open = object_of("mesh { triangle { 0, x, y } }");
  const render::Object solid = object_of("mesh { triangle { 0, x, y } inside_vector 2*z }");
  EXPECT_TRUE(open.patch);
  EXPECT_FALSE(solid.patch);
  EXPECT_EQ(mesh_of(*solid.shape)->inside_vector, Vec3(0, 0, 1));
  EXPECT_TRUE(object_of("mesh { triangle { 0, x, y } inside_vector 0 }").patch);
}

TEST(ParseMesh, DegenerateTrianglesAreDropped) {
  const auto mesh = mesh_text("mesh { triangle { 0, x, y } triangle { 0, x, 2*x } }");
  EXPECT_EQ(mesh.faces.size(), 1u);
  EXPECT_NE(parsed_object("mesh { triangle { 0, x, 2*x } }").errors.find("no triangles"), std::string::npos);
}

TEST(ParseMesh, ZeroNormalsAreReplacedWithOneWarning) {
  const ParsedObject parsed = parsed_object("mesh { smooth_triangle { 0, 0, x, 0, y, z } }");
  EXPECT_EQ(parsed.warnings, "a normal of a mesh is zero; it is taken as <1, 0, 0>\n");
  EXPECT_EQ(mesh_of(*parsed.object->shape)->normals[0], Imath::V3f(1, 0, 0));
}

TEST(ParseMesh, TexturesOfTrianglesMustBeDeclared) {
  EXPECT_NE(parsed_object("mesh { triangle { 0, x, y texture { pigment { color rgb 1 } } } }").errors, "");
}

TEST(ParseMesh2, TakesItsLists) {
  const auto mesh = mesh_text(kTextures + "mesh2 { " + kVertices +
                                      "normal_vectors { 2, z, <0, 3, 4> } uv_vectors { 2, <0, 0>, <0.5, 1> } "
                                      "texture_list { 2, texture { A }, texture { B } } "
                                      "face_indices { 3, <0, 1, 2>, <0, 1, 3>, 1, <1, 2, 3>, 0, 1, 0 } uv_indices { 3, "
                                      "<0, 1, 1>, <0, 0, 0>, <1, 1, 1> } "
                                      "normal_indices { 1, <0, 1, 1> } inside_vector y }");
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.faces, (std::vector<Corners>{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}}));
  EXPECT_EQ(mesh.face_textures, (std::vector<Corners>{MeshParameters::kNoCorners, {1, 1, 1}, {0, 1, 0}}));
  EXPECT_EQ(mesh.face_uvs[0], (Corners{0, 1, 1}));
  EXPECT_EQ(mesh.face_normals, (std::vector<Corners>{{0, 1, 1}, MeshParameters::kNoCorners, MeshParameters::kNoCorners}));
  EXPECT_NEAR(mesh.normals[1].y, 0.6, 1e-7);
  EXPECT_EQ(mesh.inside_vector, Vec3(0, 1, 0));
}

TEST(ParseMesh2, IndicesLeftOutAreThoseOfTheCorners) {
  const auto mesh =
      mesh_text("mesh2 { " + kVertices +
                        "normal_vectors { 4, x, y, z, x } uv_vectors { 4, <0, 0>, <1, 0>, <0, 1>, <1, 1> } "
                        "face_indices { 1, <0, 1, 3> } }");
  EXPECT_EQ(mesh.face_normals[0], (Corners{0, 1, 3}));
  EXPECT_EQ(mesh.face_uvs[0], (Corners{0, 1, 3}));
}

TEST(ParseMesh2, IndicesComeInEitherOrder) {
  const auto mesh =
      mesh_text("mesh2 { " + kVertices +
                        "normal_vectors { 2, x, y } uv_vectors { 2, <0, 0>, <1, 1> } face_indices { 1, <0, 1, 2> } "
                        "normal_indices { 1, <0, 1, 1> } uv_indices { 1, <1, 0, 1> } }");
  EXPECT_EQ(mesh.face_normals[0], (Corners{0, 1, 1}));
  EXPECT_EQ(mesh.face_uvs[0], (Corners{1, 0, 1}));
}

TEST(ParseMesh2, RefusesIndicesOutOfRange) {
  const std::string start = "mesh2 { " + kVertices;
  for (const char* rest :
       {"face_indices { 1, <0, 1, 4> } }", "face_indices { 1, <0, -1, 2> } }", "face_indices { 1, <0, 1, 2>, 0 } }",
        "face_indices { 0 } }", "}", "face_indices { 1, <0, 1, 2> } normal_indices { 1, <0, 0, 0> } }",
        "face_indices { 1, <0, 1, 2> } uv_indices { 2, <0, 0, 0>, <0, 0, 0> } }",
        "face_indices { 1, <0, 1, 2> } uv_indices { 1, <0, 0, 1> } }",
        "normal_vectors { 1, x } face_indices { 1, <0, 1, 2> } }",
        "uv_vectors { 2, <0, 0>, <1, 1> } face_indices { 1, <0, 1, 2> } }"}) {
    EXPECT_NE(parsed_object(start + rest).errors, "") << rest;
  }
  EXPECT_NE(parsed_object("mesh2 { face_indices { 1, <0, 1, 2> } }").errors.find("'vertex_vectors'"),
            std::string::npos);
  EXPECT_NE(parsed_object("mesh2 { vertex_vectors { 1e30 } }").errors.find("more than"), std::string::npos);
}

TEST(ParseMesh2, LaterListsOfAKindReplaceEarlierOnesWithAWarning) {
  const ParsedObject parsed =
      parsed_object("mesh2 { vertex_vectors { 1, 0 } " + kVertices + "face_indices { 1, <0, 1, 2> } }");
  EXPECT_NE(parsed.warnings.find("given before"), std::string::npos);
  EXPECT_EQ(mesh_of(*parsed.object->shape)->vertices.size(), 4u);
}

}  // namespace
}  // namespace firstlight::parser
