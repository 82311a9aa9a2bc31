#include "tests/parser/object_text.h"

#include <numbers>

namespace firstlight::parser {
namespace {

using render::Fog;
using render::Rainbow;
using render::Vec3;

Fog fog_of(const std::string& words) {
  const auto scene = described_scene("sphere { 0, 1 } fog { " + words + " }");
  return scene->atmosphere.fogs.empty() ? Fog() : scene->atmosphere.fogs[0];
}

Rainbow rainbow_of(const std::string& words) {
  const auto scene = described_scene("sphere { 0, 1 } rainbow { " + words + " }");
  return scene->atmosphere.rainbows.empty() ? Rainbow() : scene->atmosphere.rainbows[0];
}

std::string mistake(const std::string& text) { return errors(described(text)); }

TEST(ParseFog, AllItsWordsAreRead) {
  const Fog fog = fog_of(
      "fog_type 2 distance 20 color rgbft <1, 0.5, 0, 0.2, 0.3> fog_alt 0.5 fog_offset 1 up 2*x turbulence <1, 2, 3> "
      "octaves 99 omega 0.7 lambda 3 turb_depth 0.1 rotate 90*z");
  EXPECT_EQ(fog.type, Fog::kGround);
  EXPECT_EQ(fog.distance, 20.0);
  EXPECT_FLOAT_EQ(fog.color.rgb.y, 0.5f);
  EXPECT_FLOAT_EQ(fog.color.filter, 0.2f);
  EXPECT_FLOAT_EQ(fog.color.transmit, 0.3f);
  EXPECT_EQ(fog.altitude, 0.5);
  EXPECT_EQ(fog.offset, 1.0);
  expect_near(fog.up, Vec3(0, 1, 0));
  ASSERT_TRUE(fog.turbulence);
  EXPECT_EQ(fog.turbulence->amount, Vec3(1, 2, 3));
  EXPECT_EQ(fog.turbulence->octaves, 10);
  EXPECT_EQ(fog.turbulence->omega, 0.7);
  EXPECT_EQ(fog.turbulence->lambda, 3.0);
  EXPECT_EQ(fog.turbulence_depth, 0.1);
}

TEST(ParseFog, DefaultsArePovRays) {
  const Fog fog = fog_of("distance 10");
  EXPECT_EQ(fog.type, Fog::kConstant);
  EXPECT_FALSE(fog.turbulence);
  EXPECT_EQ(fog.turbulence_depth, 0.5);
  EXPECT_EQ(fog.up, Vec3(0, 1, 0));
}

TEST(ParseFog, FogsAddUpAndCanBeDeclared) {
  const auto scene = described_scene(
      "sphere { 0, 1 } #declare F = fog { distance 5 rgb x } fog { F } fog { F distance 7 color rgb y }");
  ASSERT_EQ(scene->atmosphere.fogs.size(), 2u);
  EXPECT_EQ(scene->atmosphere.fogs[1].distance, 7.0);
  EXPECT_NE(warnings(described("sphere { 0, 1 } fog { distance 5 fog_type 3 }")).find("must be 1 or 2"),
            std::string::npos);
  EXPECT_NE(warnings(described("sphere { 0, 1 } fog { distance 5 translate x }")).find("does nothing"),
            std::string::npos);
  EXPECT_NE(warnings(described("sphere { 0, 1 } fog { 5 rgb 1 }")).find("'distance'"), std::string::npos);
}

TEST(ParseRainbow, AllItsWordsAreRead) {
  const Rainbow bow = rainbow_of(
      "angle 42.5 width 5 distance 1000 jitter 0.01 direction 2*z up <0, 1, 1> arc_angle 120 falloff_angle 30 "
      "color_map { [0 rgbt 1] [1 rgbt <1, 0, 0, 0.9>] }");
  EXPECT_EQ(bow.angle, 42.5);
  EXPECT_EQ(bow.width, 5.0);
  EXPECT_EQ(bow.distance, 1000.0);
  EXPECT_EQ(bow.jitter, 0.01);
  expect_near(bow.direction, Vec3(0, 0, 1));
  expect_near(bow.up, Vec3(0, 1, 0));
  EXPECT_NEAR(bow.arc_half_angle, std::numbers::pi / 3, 1e-12);
  EXPECT_NEAR(bow.falloff_half_angle, std::numbers::pi / 12, 1e-12);
  EXPECT_EQ(bow.colors.size(), 2u);
}

TEST(ParseRainbow, ArcWithoutFalloffEndsSharply) {
  const Rainbow bow = rainbow_of("direction z arc_angle 90");
  EXPECT_EQ(bow.arc_half_angle, bow.falloff_half_angle);
  EXPECT_FALSE(bow.shows()) << "it has no width";
}

TEST(ParseRainbow, AnglesOfDeclaredOnesAreTurnedTwiceAsInPovRay) {
  const Rainbow bow = described_scene("sphere { 0, 1 } #declare R = rainbow { direction z angle 42 width 4 color_map { [0 "
                                      "rgb 1] } } rainbow { R }")
                          ->atmosphere.rainbows[0];
  EXPECT_NEAR(bow.angle, 40.0 * std::numbers::pi / 180, 1e-12);
  EXPECT_NEAR(bow.width, 4.0 * std::numbers::pi / 180, 1e-12);
}

TEST(ParseRainbow, RefusesWhatMakesNoSense) {
  for (const char* words : {"angle 42", "direction 0", "direction z up 0", "direction y", "direction z arc_angle 400",
                            "direction z falloff_angle -1", "direction z arc_angle 30 falloff_angle 60"}) {
    EXPECT_NE(mistake("rainbow { " + std::string(words) + " }").find("'"), std::string::npos) << words;
  }
}

TEST(ParseSkySphere, TakesPigmentsAndEmission) {
  const auto scene = described_scene(
      "sphere { 0, 1 } sky_sphere { pigment { gradient y } pigment { color rgbt 0.5 } emission rgb 2 scale 3 rotate x "
      "}");
  ASSERT_TRUE(scene->atmosphere.sky_sphere);
  const render::SkySphere& sky = *scene->atmosphere.sky_sphere;
  EXPECT_EQ(sky.pigments.size(), 2u);
  EXPECT_FLOAT_EQ(sky.emission.x, 2.0f);
  expect_near(sky.placement.point(Vec3(1, 0, 0)), Vec3(3, 0, 0));
}

TEST(ParseSkySphere, LastOneCounts) {
  const auto result = described(
      "sphere { 0, 1 } #declare S = sky_sphere { pigment { rgb 1 } } sky_sphere { S } sky_sphere { S pigment { rgb 0 } "
      "}");
  EXPECT_NE(warnings(result).find("the last one counts"), std::string::npos);
  EXPECT_EQ(result.scene->atmosphere.sky_sphere->pigments.size(), 2u);
  EXPECT_NE(mistake("sky_sphere { }").find("at least one 'pigment'"), std::string::npos);
}

TEST(ParseBackground, KeepsItsColourForPicturesWithAlpha) {
  const auto scene = described_scene("sphere { 0, 1 } background { rgbt <1, 0.5, 0, 0.5> }");
  EXPECT_FLOAT_EQ(scene->settings.background.x, 0.5f);
  EXPECT_FLOAT_EQ(scene->settings.background_with_alpha.rgb.x, 1.0f);
  EXPECT_FLOAT_EQ(scene->settings.background_with_alpha.transmit, 0.5f);
  EXPECT_FLOAT_EQ(described_scene("sphere { 0, 1 }")->settings.background_with_alpha.transmit, 1.0f);
}

}  // namespace
}  // namespace firstlight::parser
