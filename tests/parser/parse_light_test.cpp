#include "tests/parser/object_text.h"

namespace firstlight::parser {
namespace {

using render::Light;
using render::LightKind;
using render::Vec3;

Light light_of(const std::string& rest) {
  return object_of("light_source { <1, 2, 3>, rgb 1 " + rest + " }").extras->light;
}
std::string mistake(const std::string& rest) { return parsed_object("light_source { 0, rgb 1 " + rest + " }").errors; }

TEST(ParseLight, DefaultsArePovRays) {
  const Light light = light_of("");
  EXPECT_EQ(light.kind, LightKind::point);
  EXPECT_FALSE(light.parallel || light.shadowless || light.area || light.jitter || light.circular || light.orient);
  EXPECT_EQ(light.adaptive, 100);
  EXPECT_FALSE(light.media_attenuation);
  EXPECT_TRUE(light.media_interaction);
  EXPECT_EQ(light.point_at, Vec3(0, 0, 1));
  EXPECT_TRUE(light.unrendered.empty());
}

TEST(ParseLight, SpotlightHasAConeAroundItsAxis) {
  const Light plain = light_of("spotlight");
  EXPECT_EQ(plain.kind, LightKind::spotlight);
  EXPECT_EQ(plain.radius, 30.0);
  EXPECT_EQ(plain.falloff, 45.0);
  EXPECT_EQ(plain.tightness, 0.0);
  const Light light = light_of("spotlight point_at y radius 10 falloff 20 tightness 5");
  EXPECT_EQ(light.point_at, Vec3(0, 1, 0));
  EXPECT_EQ(light.radius, 10.0);
  EXPECT_EQ(light.falloff, 20.0);
  EXPECT_EQ(light.tightness, 5.0);
  EXPECT_EQ(spelled(light.unrendered), "");
}

TEST(ParseLight, CylinderIsParallel) {
  const Light light = light_of("cylinder point_at 0");
  EXPECT_EQ(light.kind, LightKind::cylinder);
  EXPECT_TRUE(light.parallel);
  EXPECT_EQ(light.radius, 0.75);
  EXPECT_EQ(light.falloff, 1.0);
  EXPECT_EQ(spelled(light.unrendered), "");
}

TEST(ParseLight, LastWordAboutTheBeamCounts) {
  EXPECT_EQ(light_of("spotlight shadowless").kind, LightKind::point);
  EXPECT_TRUE(light_of("spotlight shadowless").shadowless);
  EXPECT_FALSE(light_of("shadowless spotlight").shadowless);
}

TEST(ParseLight, ParallelLightPointsSomewhere) {
  const Light light = light_of("parallel point_at x");
  EXPECT_TRUE(light.parallel);
  EXPECT_EQ(light.point_at, Vec3(1, 0, 0));
  for (const char* word : {"point_at 0", "radius 1", "falloff 1", "tightness 1", "parallel radius 1"}) {
    EXPECT_NE(mistake(word).find("does not go with"), std::string::npos) << word;
  }
}

TEST(ParseLight, AreaLightTakesAxesAndSizes) {
  const Light light =
      light_of("area_light <4, 0, 0>, <0, 0, 4>, 5, 6 adaptive 1 jitter circular orient area_illumination");
  ASSERT_TRUE(light.area);
  EXPECT_EQ(light.area->axis1, Vec3(4, 0, 0));
  EXPECT_EQ(light.area->axis2, Vec3(0, 0, 4));
  EXPECT_EQ(light.area->size1, 5);
  EXPECT_EQ(light.area->size2, 6);
  EXPECT_EQ(light.adaptive, 1);
  EXPECT_TRUE(light.jitter && light.circular && light.orient && light.area_illumination);
  EXPECT_EQ(spelled(light.unrendered), "");
  EXPECT_FALSE(light_of("area_light x, y, 2, 2 area_illumination off").area_illumination);
}

TEST(ParseLight, AreaLightNeedsPoints) {
  EXPECT_NE(mistake("area_light x, y, 0, 2").find("above 0"), std::string::npos);
  EXPECT_NE(mistake("area_light x, y, 1, 2 circular").find("more than one point"), std::string::npos);
  EXPECT_NE(parsed_object("light_source { 0, 1 orient }").warnings.find("without 'area_light'"), std::string::npos);
}

TEST(ParseLight, TransformationsActWhereTheyStand) {
  const Light light = light_of("area_light x, y, 2, 2 parallel point_at 0 rotate 90*z translate 2*x");
  expect_near(light.position, Vec3(0, 1, 3));
  expect_near(light.point_at, Vec3(2, 0, 0));
  expect_near(light.area->axis1, Vec3(0, 1, 0));
  EXPECT_EQ(light_of("translate x parallel point_at y").point_at, Vec3(0, 1, 0));
}

TEST(ParseLight, LooksLikeIsAnObjectAroundTheLight) {
  const Light light = light_of("looks_like { sphere { 0, 1 } scale 2 } translate x");
  ASSERT_TRUE(light.looks_like);
  EXPECT_TRUE(light.looks_like->no_shadow);
  expect_near(light.looks_like->placement.point(Vec3(0, 0, 0)), Vec3(3, 4, 6));
  EXPECT_EQ(spelled(light.unrendered), "");
  EXPECT_NE(mistake("looks_like { sphere { 0, 1 } } looks_like { sphere { 0, 1 } }").find("only one"),
            std::string::npos);
  EXPECT_NE(mistake("looks_like { }").find("an object"), std::string::npos);
}

TEST(ParseLight, ProjectedThroughIsAnObject) {
  const Light light = light_of("projected_through { box { -1, 1 } translate 5*z }");
  ASSERT_TRUE(light.projected_through);
  expect_near(light.projected_through->placement.point(Vec3(0, 0, 0)), Vec3(0, 0, 5));
  EXPECT_EQ(spelled(light.unrendered), "");
  EXPECT_NE(mistake("projected_through { sphere { 0, 1 } } projected_through { sphere { 0, 1 } }").find("only one"),
            std::string::npos);
}

TEST(ParseLight, ObjectsOfALightMoveWithItsUnion) {
  const auto scene = described_scene(
      "union { sphere { 0, 1 } light_source { x, rgb 1 looks_like { sphere { 0, 1 } } } translate y }");
  ASSERT_EQ(scene->lights.size(), 1u);
  expect_near(scene->lights[0].looks_like->placement.point(Vec3(0, 0, 0)), Vec3(1, 1, 0));
}

TEST(ParseLight, MediaAndPhotonsAreRead) {
  const Light light =
      light_of("media_attenuation on media_interaction off photons { reflection on refraction off area_light }");
  EXPECT_TRUE(light.media_attenuation);
  EXPECT_FALSE(light.media_interaction);
  EXPECT_EQ(light.photon_reflection, true);
  EXPECT_EQ(light.photon_refraction, false);
  EXPECT_TRUE(light.photon_area_light);
  EXPECT_TRUE(light.unrendered.empty());
}

TEST(ParseLight, ColorMapGivesTheSumOfItsColours) {
  const Light light = light_of("color_map { [0.5 rgb <1, 0, 0>] [1 rgb <0, 1, 0>] }");
  EXPECT_FLOAT_EQ(light.color.x, 0.5f);
  EXPECT_FLOAT_EQ(light.color.y, 1.0f);
}

}  // namespace
}  // namespace firstlight::parser
