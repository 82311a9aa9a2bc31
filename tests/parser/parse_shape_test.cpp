#include "tests/parser/scene_text.h"

namespace firstlight::parser {
namespace {

using render::Vec3;
using testing::Test;

TEST(ParseShape, SphereTakesCenterAndRadius) {
  const auto scene = scene_of("sphere { <1, 2, 3>, 0.5 }");
  ASSERT_EQ(scene->solids.size(), 1u);
  EXPECT_TRUE(inside(*scene, Vec3(1, 2, 3.49)));
  EXPECT_FALSE(inside(*scene, Vec3(1, 2, 3.51)));
}

TEST(ParseShape, CommasMayBeLeftOut) {
  const auto scene = scene_of("cylinder { <0, 0, 0> <0, 3, 0> 1 } box { -1 1 } sphere { 0 1 }");
  EXPECT_TRUE(inside(*scene, Vec3(0.9, 2.9, 0)));
}

TEST(ParseShape, BoxCornersComeInAnyOrder) {
  const auto scene = scene_of("box { <1, -1, 5>, <-1, 1, 2> }");
  EXPECT_TRUE(inside(*scene, Vec3(0, 0, 3)));
  EXPECT_FALSE(inside(*scene, Vec3(0, 0, 1)));
}

TEST(ParseShape, PlaneDistanceIsAlongTheNormalWhateverItsLength) {
  const auto scene = scene_of("plane { 4*y, 2 }");
  EXPECT_TRUE(inside(*scene, Vec3(0, 1.9, 0)));
  EXPECT_FALSE(inside(*scene, Vec3(0, 2.1, 0)));
}

TEST(ParseShape, ConeTakesARadiusAtEachEnd) {
  const auto scene = scene_of("cone { 0, 2, 4*y, 0 }");
  EXPECT_TRUE(inside(*scene, Vec3(0.9, 2, 0)));
  EXPECT_FALSE(inside(*scene, Vec3(1.1, 2, 0)));
}

TEST(ParseShape, TorusTakesMajorAndMinorRadius) {
  const auto scene = scene_of("torus { 3, 0.5 sturm }");
  EXPECT_TRUE(inside(*scene, Vec3(3.4, 0, 0)));
  EXPECT_FALSE(inside(*scene, Vec3(2, 0, 0)));
}

TEST(ParseShape, OpenCylinderHasNoCaps) {
  const auto scene = scene_of("cylinder { 0, y, 1 open } cylinder { 0, y, 1 }");
  const render::Ray ray{Vec3(0.5, 5, 0), Vec3(0, -1, 0)};
  std::vector<render::Crossing> open, closed;
  scene->solids.at(0).crossings(ray, 0, open);
  scene->solids.at(1).crossings(ray, 0, closed);
  EXPECT_EQ(open.size(), 0u);
  EXPECT_EQ(closed.size(), 2u);
}

TEST(ParseShape, DiscHasAHole) {
  const auto scene = scene_of("disc { 0, y, 2, 1 }");
  std::vector<render::Crossing> through, beside;
  scene->solids.at(0).crossings({Vec3(0.5, 5, 0), Vec3(0, -1, 0)}, 0, through);
  scene->solids.at(0).crossings({Vec3(1.5, 5, 0), Vec3(0, -1, 0)}, 0, beside);
  EXPECT_EQ(through.size(), 0u);
  EXPECT_EQ(beside.size(), 1u);
}

TEST(ParseShape, SmoothTriangleIsRead) {
  const auto scene = scene_of("smooth_triangle { 0, -z, x, -z, y, -z }");
  EXPECT_EQ(scene->solids.size(), 1u);
}

TEST(ParseShape, DegenerateTriangleIsLeftOutWithAWarning) {
  const auto result = load("triangle { 0, x, 2*x } sphere { 0, 1 }");
  ASSERT_TRUE(result.scene);
  EXPECT_EQ(result.scene->solids.size(), 1u);
  EXPECT_NE(warnings(result).find("'triangle' is degenerate"), std::string::npos);
}

TEST(ParseShape, CylinderWithoutLengthIsAnError) {
  const auto result = load("cylinder { y, y, 1 }");
  EXPECT_FALSE(result.scene);
  EXPECT_NE(errors(result).find("'cylinder' has no length"), std::string::npos);
}

TEST(ParseShape, PlaneWithoutNormalIsAnError) {
  EXPECT_NE(errors(load("plane { 0, 1 }")).find("normal of 'plane'"), std::string::npos);
}

TEST(ParseShape, MissingBraceIsNamed) {
  const auto result = load_bare("sphere { 0, 1\nbox { 0, 1 }\ncamera { }");
  ASSERT_FALSE(result.scene);
  EXPECT_EQ(result.diagnostics.front().line, 2u);
  EXPECT_NE(errors(result).find("'}'"), std::string::npos);
  EXPECT_NE(errors(result).find("'box'"), std::string::npos);
}

}  // namespace
}  // namespace firstlight::parser
