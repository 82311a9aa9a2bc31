#include "tests/parser/scene_text.h"

namespace firstlight::parser {
namespace {

using render::Rgb;
using render::Vec3;

void expect_color(const render::FilteredColor& color, const Rgb& rgb, float filter = 0.0f, float transmit = 0.0f) {
  EXPECT_FLOAT_EQ(color.rgb.x, rgb.x);
  EXPECT_FLOAT_EQ(color.rgb.y, rgb.y);
  EXPECT_FLOAT_EQ(color.rgb.z, rgb.z);
  EXPECT_FLOAT_EQ(color.filter, filter);
  EXPECT_FLOAT_EQ(color.transmit, transmit);
}

TEST(ParseTexture, SolidColorsComeInAllForms) {
  const auto scene = scene_of(
      "#declare Red = rgb <1, 0, 0>; sphere { 0, 1 pigment { color Red } } sphere { 0, 1 pigment { Red } }"
      "sphere { 0, 1 pigment { red 1 } } sphere { 0, 1 pigment { rgbft <1, 0, 0, 0.5, 0.25> } }"
      "sphere { 0, 1 texture { pigment { color rgb x } } }");
  for (std::size_t part : {0, 1, 2, 4}) expect_color(color_of(*scene, Vec3(0.0), part), Rgb(1, 0, 0));
  expect_color(color_of(*scene, Vec3(0.0), 3), Rgb(1, 0, 0), 0.5f, 0.25f);
}

TEST(ParseTexture, DeclaredPigmentIsAStartThatTheBlockAlters) {
  const auto scene = scene_of(
      "#declare P = pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } }"
      "sphere { 0, 1 pigment { P scale 4 } } sphere { 0, 1 pigment { P color_map { [0 rgb x] [1 rgb x] } } }");
  expect_color(color_of(*scene, Vec3(1, 0, 0), 0), Rgb(0.25f));
  expect_color(color_of(*scene, Vec3(0.5, 0, 0), 1), Rgb(1, 0, 0));
}

TEST(ParseTexture, SurfacesThatDifferInTheirColorAloneShareTheRest) {
  const auto scene = scene_of("sphere { 0, 1 pigment { rgb 1 } } sphere { 0, 1 texture { pigment { color rgb x } } }");
  const auto& first = scene->textures.at(0).texture->layers[0];
  const auto& second = scene->textures.at(1).texture->layers[0];
  EXPECT_TRUE(first.pigment.pattern.is_same(second.pigment.pattern));
  EXPECT_TRUE(first.finish.is_same(second.finish));
  EXPECT_EQ(first.pigment.pattern->kind, render::PatternKind::plain);
}

TEST(ParseTexture, EqualFinishesOneAfterAnotherAreKeptOnce) {
  const auto scene = scene_of(
      "#for (I, 1, 3) sphere { 0, 1 texture { pigment { rgb I } finish { phong 0.5 } } } #end"
      " sphere { 0, 1 finish { phong 0.25 } } sphere { 0, 1 finish { phong 0.5 } }");
  const auto finish = [&](std::size_t part) {
    return scene->textures.at(scene->parts.at(part).texture).texture->layers[0].finish;
  };
  EXPECT_TRUE(finish(0).is_same(finish(1)) && finish(1).is_same(finish(2)));
  EXPECT_FALSE(finish(3).is_same(finish(2)));
  EXPECT_EQ(finish(2)->phong, 0.5);
  EXPECT_EQ(finish(3)->phong, 0.25);
  EXPECT_EQ(finish(4)->phong, 0.5);
}

TEST(ParseTexture, AColorTakesThePlaceOfAPattern) {
  const auto scene = scene_of(
      "#declare P = pigment { checker rgb 1, rgb 0 scale 2 } sphere { 0, 1 pigment { P color rgb x } }"
      "sphere { 0, 1 pigment { P } }");
  for (const double x : {0.5, 2.5}) expect_color(color_of(*scene, Vec3(x, 0.5, 0.5), 0), Rgb(1, 0, 0));
  expect_color(color_of(*scene, Vec3(2.5, 0.5, 0.5), 1), Rgb(0, 0, 0));
}

TEST(ParseTexture, ColorMapTakesOldEntriesOfTwoColors) {
  const auto scene = scene_of(
      "sphere { 0, 1 pigment { gradient x color_map { [0.0 0.5 color red 1 color green 1] [0.5 1.0 color blue 1 color "
      "rgb 1] } } }");
  expect_color(color_of(*scene, Vec3(0.25, 0, 0)), Rgb(0.5f, 0.5f, 0));
  expect_color(color_of(*scene, Vec3(0.75, 0, 0)), Rgb(0.5f, 0.5f, 1));
}

TEST(ParseTexture, DeclaredColorMapCanBeUsed) {
  const auto scene =
      scene_of("#declare M = color_map { [0 rgb 0] [1 rgb 1] } sphere { 0, 1 pigment { gradient x color_map { M } } }");
  expect_color(color_of(*scene, Vec3(0.5, 0, 0)), Rgb(0.5f));
}

TEST(ParseTexture, GradientWithoutMapGoesFromBlackToWhite) {
  const auto scene = scene_of("sphere { 0, 1 pigment { gradient 5*y } }");
  expect_color(color_of(*scene, Vec3(0, 0.25, 0)), Rgb(0.25f));
}

TEST(ParseTexture, CheckerIsBlueAndGreenUnlessColorsAreGiven) {
  const auto scene = scene_of(
      "plane { y, 0 pigment { checker } } plane { y, 0 pigment { checker rgb 1 } }"
      "plane { y, 0 pigment { checker rgb 1, rgb x scale 2 } } plane { y, 0 pigment { checker pigment { rgb 1 } "
      "pigment { rgb y } } }");
  const Vec3 even(0.5, 0.5, 0.5), odd(1.5, 0.5, 0.5);
  expect_color(color_of(*scene, even, 0), Rgb(0, 0, 1));
  expect_color(color_of(*scene, odd, 0), Rgb(0, 1, 0));
  expect_color(color_of(*scene, even, 1), Rgb(1));
  expect_color(color_of(*scene, odd, 1), Rgb(0, 1, 0));
  expect_color(color_of(*scene, 2.0 * odd, 2), Rgb(1, 0, 0));
  expect_color(color_of(*scene, odd, 3), Rgb(0, 1, 0));
}

TEST(ParseTexture, WaveWordsAreKept) {
  const auto scene = scene_of("sphere { 0, 1 pigment { gradient x poly_wave 2 frequency 3 phase 0.25 } }");
  const render::Wave& wave = scene->textures.at(scene->parts.at(0).texture).texture->layers[0].pigment.pattern->wave;
  EXPECT_EQ(wave.form, render::WaveForm::poly);
  EXPECT_EQ(wave.exponent, 2.0);
  EXPECT_EQ(wave.frequency, 3.0);
  EXPECT_EQ(wave.phase, 0.25);
}

TEST(ParseTexture, OnlyTransformationsBehindATextureMoveIt) {
  const auto scene = scene_of(
      "sphere { 0, 1 pigment { gradient x } translate 0.25*x }"
      "sphere { 0, 1 translate 0.25*x pigment { gradient x } }");
  expect_color(color_of(*scene, Vec3(0.5, 0, 0), 0), Rgb(0.25f));
  expect_color(color_of(*scene, Vec3(0.5, 0, 0), 1), Rgb(0.5f));
}

TEST(ParseTexture, TextureTransformationsMoveTheLayersThatAreThere) {
  const auto scene =
      scene_of("sphere { 0, 1 texture { pigment { gradient x } translate 0.25*x pigment { phase 0.0 } } }");
  expect_color(color_of(*scene, Vec3(0.5, 0, 0)), Rgb(0.25f));
}

TEST(ParseTexture, ChildrenKeepTheirTexturesAndMoveWithTheParent) {
  const auto scene =
      scene_of("union { sphere { 0, 1 pigment { gradient x } } sphere { 0, 1 } pigment { rgb y } translate 0.25*x }");
  expect_color(color_of(*scene, Vec3(0.5, 0, 0), 0), Rgb(0.25f));
  expect_color(color_of(*scene, Vec3(0.5, 0, 0), 1), Rgb(0, 1, 0));
}

TEST(ParseTexture, LaterTextureLiesOnTop) {
  const auto scene = scene_of(
      "sphere { 0, 1 texture { pigment { rgb x } } translate x texture { pigment { rgbt <0, 1, 0, 0.5> } } }"
      "#declare T = texture { pigment { rgb x } } texture { pigment { rgbt <0, 0, 1, 0.5> } }"
      "sphere { 0, 1 texture { T } }");
  expect_color(color_of(*scene, Vec3(0.0), 0, 0), Rgb(0, 1, 0), 0, 0.5f);
  expect_color(color_of(*scene, Vec3(0.0), 0, 1), Rgb(1, 0, 0));
  expect_color(color_of(*scene, Vec3(0.0), 1, 0), Rgb(0, 0, 1), 0, 0.5f);
  expect_color(color_of(*scene, Vec3(0.0), 1, 1), Rgb(1, 0, 0));
}

TEST(ParseTexture, LowerLayerMovesWithTheObjectBeforeTheUpperOneComes) {
  const auto scene = scene_of(
      "sphere { 0, 1 texture { pigment { gradient x } } translate 0.25*x texture { pigment { gradient x } } translate "
      "0.25*x }");
  expect_color(color_of(*scene, Vec3(0.75, 0, 0), 0, 0), Rgb(0.5f));
  expect_color(color_of(*scene, Vec3(0.75, 0, 0), 0, 1), Rgb(0.25f));
}

TEST(ParseTexture, PigmentInAnObjectAltersTheTextureThatIsThere) {
  const auto scene = scene_of(
      "#declare T = texture { pigment { rgb x } finish { diffuse 0.9 } } sphere { 0, 1 texture { T } pigment { rgb z } "
      "}"
      "sphere { 0, 1 finish { diffuse 0.1 } pigment { rgb z } }");
  expect_color(color_of(*scene, Vec3(0.0), 0), Rgb(0, 0, 1));
  EXPECT_EQ(finish_of(*scene, 0).diffuse, 0.9);
  EXPECT_EQ(finish_of(*scene, 1).diffuse, 0.1);
}

TEST(ParseTexture, DefaultAppliesToObjectsFinishedAfterIt) {
  const auto scene = scene_of(
      "sphere { 0, 1 } #default { pigment { rgb x } finish { ambient 0.7 } } sphere { 0, 1 }"
      "union { sphere { 0, 1 } #default { texture { pigment { rgb y } } } sphere { 0, 1 pigment { rgb z } } }");
  expect_color(color_of(*scene, Vec3(0.0), 0), Rgb(0.0f));
  expect_color(color_of(*scene, Vec3(0.0), 1), Rgb(1, 0, 0));
  expect_color(color_of(*scene, Vec3(0.0), 2), Rgb(0, 1, 0));
  expect_color(color_of(*scene, Vec3(0.0), 3), Rgb(0, 0, 1));
  EXPECT_FLOAT_EQ(finish_of(*scene, 0).ambient.x, 0.1f);
  EXPECT_FLOAT_EQ(finish_of(*scene, 2).ambient.x, 0.7f);
}

TEST(ParseTexture, InteriorTextureNeedsATexture) {
  const auto scene = scene_of("sphere { 0, 1 texture { pigment { rgb x } } interior_texture { pigment { rgb y } } }");
  ASSERT_NE(scene->parts.at(0).interior_texture, render::kNoIndex);
  EXPECT_NE(errors(load("sphere { 0, 1 interior_texture { pigment { rgb y } } }")).find("needs a 'texture'"),
            std::string::npos);
}

TEST(ParseTexture, MaterialBringsTextureAndInterior) {
  const auto scene = scene_of(
      "#declare M = material { texture { pigment { rgbf <1, 1, 1, 1> } } interior { ior 1.5 fade_distance 2 fade_power "
      "1001 fade_color rgb y } }"
      "sphere { 0, 1 material { M } }");
  const render::Interior& interior = scene->interiors.at(scene->parts.at(0).interior);
  EXPECT_EQ(interior.ior, 1.5);
  EXPECT_EQ(interior.fade_distance, 2.0);
  EXPECT_EQ(interior.fade_power, 1001.0);
  EXPECT_FLOAT_EQ(interior.fade_color.y, 1.0f);
  expect_color(color_of(*scene, Vec3(0.0)), Rgb(1), 1.0f);
}

TEST(ParseTexture, ReflectionHasAnOldAndANewForm) {
  const auto scene = scene_of(
      "sphere { 0, 1 finish { reflection 0.3 reflection_exponent 2 } } sphere { 0, 1 finish { reflection { 0.1, 0.9 "
      "falloff 3 metallic 0.5 exponent 4 } } }"
      "sphere { 0, 1 finish { reflection { 0.8 fresnel } conserve_energy } interior { ior 1.3 } } sphere { 0, 1 finish "
      "{ reflection rgb x } }");
  EXPECT_FLOAT_EQ(finish_of(*scene, 0).reflection_min.x, 0.3f);
  EXPECT_FLOAT_EQ(finish_of(*scene, 0).reflection_max.z, 0.3f);
  EXPECT_EQ(finish_of(*scene, 0).reflection_exponent, 0.5);
  EXPECT_FLOAT_EQ(finish_of(*scene, 1).reflection_min.x, 0.1f);
  EXPECT_FLOAT_EQ(finish_of(*scene, 1).reflection_max.x, 0.9f);
  EXPECT_EQ(finish_of(*scene, 1).reflection_falloff, 3.0);
  EXPECT_EQ(finish_of(*scene, 1).reflection_metallic, 0.5);
  EXPECT_EQ(finish_of(*scene, 1).reflection_exponent, 0.25);
  EXPECT_TRUE(finish_of(*scene, 2).reflection_fresnel);
  EXPECT_FLOAT_EQ(finish_of(*scene, 2).reflection_min.x, 0.0f);
  EXPECT_FLOAT_EQ(finish_of(*scene, 2).reflection_max.x, 0.8f);
  EXPECT_TRUE(finish_of(*scene, 2).conserve_energy);
  EXPECT_FLOAT_EQ(finish_of(*scene, 3).reflection_max.y, 0.0f);
}

TEST(ParseTexture, AlbedoScalesStrengthsByTheirExponents) {
  const auto scene = scene_of(
      "sphere { 0, 1 finish { diffuse albedo 0.5, 0.2 brilliance 3 phong albedo 0.1 phong_size 39 specular albedo 0.4 "
      "roughness 0.1 } }");
  const render::Finish& finish = finish_of(*scene);
  EXPECT_DOUBLE_EQ(finish.diffuse, 1.0);
  EXPECT_DOUBLE_EQ(finish.diffuse_back, 0.4);
  EXPECT_DOUBLE_EQ(finish.phong, 2.0);
  EXPECT_DOUBLE_EQ(finish.roughness_exponent, 10.0);
  EXPECT_DOUBLE_EQ(finish.specular, 0.4 * 12.0 / (4.0 * (2.0 - 0.03125)));
}

TEST(ParseTexture, OldFinishGivesTheInteriorItsIor) {
  const auto result = load("sphere { 0, 1 finish { refraction 1 ior 1.7 } }");
  ASSERT_TRUE(result.scene);
  EXPECT_EQ(result.scene->interiors.at(result.scene->parts.at(0).interior)->ior, 1.7);
  EXPECT_NE(warnings(result).find("'ior' belongs in 'interior'"), std::string::npos);
}

TEST(ParseTexture, LayersAreLimited) {
  EXPECT_NE(errors(load("#declare T = texture { pigment { rgb 1 } } #for (I, 1, 40) #declare T = texture { T } texture "
                        "{ T } #end"))
                .find("more than 1000 layers"),
            std::string::npos);
}

TEST(ParseTexture, ColorMapDoesNotGoWithASingleColor) {
  EXPECT_NE(errors(load("sphere { 0, 1 pigment { rgb 1 color_map { [0 rgb 1] } } }")).find("'color_map' does not go"),
            std::string::npos);
  EXPECT_NE(errors(load("sphere { 0, 1 pigment { gradient x color_map { } } }")), "");
}

}  // namespace
}  // namespace firstlight::parser
