#include "tests/parser/scene_text.h"

namespace firstlight::parser {
namespace {

using render::Camera;
using render::Vec3;

Camera camera_of(const std::string& text) {
  const auto result = load_bare("#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 } " + text);
  EXPECT_EQ(errors(result), "") << text;
  return result.scene ? result.scene->camera : Camera();
}

TEST(ParseCamera, DefaultsArePovRays) {
  const Camera camera = camera_of("camera { }");
  expect_near(camera.location, Vec3(0, 0, 0));
  expect_near(camera.direction, Vec3(0, 0, 1));
  expect_near(camera.right, Vec3(1.33, 0, 0));
  expect_near(camera.up, Vec3(0, 1, 0));
}

TEST(ParseCamera, OrderOfWordsDoesNotMatter) {
  const Camera a =
      camera_of("camera { look_at <1, 2, 3> angle 40 location <4, 5, -6> right 2*x up 1.5*y sky <1, 1, 0> }");
  const Camera b =
      camera_of("camera { sky <1, 1, 0> up 1.5*y right 2*x location <4, 5, -6> angle 40 look_at <1, 2, 3> }");
  expect_near(a.direction, b.direction);
  expect_near(a.right, b.right);
  expect_near(a.up, b.up);
  EXPECT_NEAR(a.right.length(), 2.0, 1e-12);
  EXPECT_NEAR(a.direction.length(), 1.0 / std::tan(20.0 * 3.14159265358979323846 / 180.0), 1e-12);
}

TEST(ParseCamera, TransformationsComeLast) {
  const Camera camera = camera_of("camera { translate 5*x location -2*z look_at 0 }");
  expect_near(camera.location, Vec3(5, 0, -2));
  expect_near(camera.direction, Vec3(0, 0, 1));
}

TEST(ParseCamera, BeforeVersion35EveryWordActsWhereItStands) {
  const Camera camera = camera_of("#version 3.1; camera { location -2*z look_at x*2 direction 3*z }");
  expect_near(camera.direction, Vec3(0, 0, 3));
}

TEST(ParseCamera, DeclaredCameraCanBeMoved) {
  const Camera camera = camera_of("#declare C = camera { location -2*z } camera { C translate y }");
  expect_near(camera.location, Vec3(0, 1, -2));
}

TEST(ParseCamera, LookingAlongTheSkyIsAWarningAndRightDecides) {
  const auto result = load_bare("sphere { 0, 1 } camera { location 5*y look_at 0 }");
  ASSERT_TRUE(result.scene);
  EXPECT_NE(warnings(result).find("'sky'"), std::string::npos);
  expect_near(result.scene->camera.right, Vec3(1.33, 0, 0));
}

TEST(ParseCamera, LookingAtItselfIsAnError) {
  EXPECT_NE(errors(load_bare("camera { location y look_at y }")).find("must be different points"), std::string::npos);
}

TEST(ParseCamera, LastOfSeveralCountsWithAWarning) {
  const auto result = load_bare("#version 3.7; sphere { 0, 1 } camera { location x look_at 0 } camera { up 2*y }");
  ASSERT_TRUE(result.scene);
  expect_near(result.scene->camera.location, Vec3(0, 0, 0));
  EXPECT_NE(warnings(result).find("more than one camera"), std::string::npos);
}

TEST(ParseCamera, AngleMustBeBelow180) {
  EXPECT_NE(errors(load_bare("camera { angle 180 }")), "");
  EXPECT_NE(errors(load_bare("camera { angle -1 }")), "");
}

TEST(ParseLight, PointLightWithFadingAndTransformations) {
  const auto scene =
      scene_of("light_source { <1, 2, 3>, rgb <1, 0.5, 0> fade_distance 4 fade_power 2 shadowless translate x }");
  ASSERT_EQ(scene->lights.size(), 1u);
  const render::Light& light = scene->lights[0];
  expect_near(light.position, Vec3(2, 2, 3));
  EXPECT_FLOAT_EQ(light.color.y, 0.5f);
  EXPECT_EQ(light.fade_distance, 4.0);
  EXPECT_EQ(light.fade_power, 2.0);
  EXPECT_TRUE(light.shadowless);
}

TEST(ParseLight, LightsInUnionsMoveWithThem) {
  const auto scene = scene_of("union { sphere { 0, 1 } light_source { x, rgb 1 } translate 2*x rotate 90*y }");
  ASSERT_EQ(scene->lights.size(), 1u);
  expect_near(scene->lights[0].position, Vec3(0, 0, -3));
}

TEST(ParseSettings, GlobalSettingsAreKept) {
  const auto scene = scene_of(
      "global_settings { ambient_light rgb <1, 2, 3> max_trace_level 9 adc_bailout 0.01 noise_generator 2 charset utf8 "
      "mm_per_unit 5 } sphere { 0, 1 }");
  EXPECT_FLOAT_EQ(scene->settings.ambient_light.z, 3.0f);
  EXPECT_EQ(scene->settings.max_trace_level, 9);
  EXPECT_EQ(scene->settings.adc_bailout, 0.01);
}

TEST(ParseSettings, TraceLevelIsHeldBetween1And256) {
  EXPECT_EQ(scene_of("global_settings { max_trace_level 0 } sphere { 0, 1 }")->settings.max_trace_level, 1);
  const auto result = load("global_settings { max_trace_level 1000 } sphere { 0, 1 }");
  ASSERT_TRUE(result.scene);
  EXPECT_EQ(result.scene->settings.max_trace_level, 256);
  EXPECT_NE(warnings(result).find("taken as 256"), std::string::npos);
}

TEST(ParseScene, BackgroundIsMixedWithBlackWhereItTransmits) {
  const auto scene = scene_of("background { rgbt <1, 0.5, 0, 0.5> } sphere { 0, 1 }");
  EXPECT_FLOAT_EQ(scene->settings.background.x, 0.5f);
  EXPECT_FLOAT_EQ(scene->settings.background.y, 0.25f);
}

TEST(ParseScene, SceneWithoutACameraGetsTheDefaultOne) {
  const auto result = load_bare("#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 }\n");
  ASSERT_TRUE(result.scene);
  EXPECT_EQ(warnings(result), "there is no camera in the scene; the default one is taken\n");
  EXPECT_EQ(result.scene->camera.location.z, Camera().location.z);
}

TEST(ParseScene, SceneWithoutObjectsIsAWarning) {
  const auto result = load("");
  EXPECT_TRUE(result.scene);
  EXPECT_NE(warnings(result).find("no objects"), std::string::npos);
}

TEST(ParseScene, WhatIsNoStatementIsNamed) {
  EXPECT_NE(errors(load("42")).find("expected an object or a directive"), std::string::npos);
  EXPECT_NE(errors(load("roughness 0.1")).find("'roughness'"), std::string::npos);
  EXPECT_EQ(errors(load("media { emission 1 }")), "'media' cannot be rendered by this version of Firstlight\n");
}

}  // namespace
}  // namespace firstlight::parser
