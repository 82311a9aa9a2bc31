#include "render/texture/pigment.h"

#include "render/texture/patterns.h"
#include "render/texture/texture.h"
#include "tests/render/pattern_test_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace firstlight::render {
namespace {

FilteredColor grey_of(float level) {
  FilteredColor color;
  color.rgb = Rgb(level);
  return color;
}

/// Along x from black to white, so that the red of a colour is the place in the map.
Pigment ramp(Wave wave) {
  Pigment pigment;
  pigment.pattern = PigmentPattern{patterned(PatternKind::gradient, GradientParameters{{1.0, 0.0, 0.0}}),
                                   {{0.0, grey_of(0.0f)}, {1.0, grey_of(1.0f)}}};
  pigment.pattern.change().wave = wave;
  return pigment;
}

double level_at(const Pigment& pigment, double x) { return color_at(pigment, {x, 0.0, 0.0}).rgb.x; }

AskedPattern gradient_of(const Vec3& axis) { return AskedPattern(PatternKind::gradient, GradientParameters{axis}); }

TEST(Pattern, GradientCountsAlongItsAxisWhateverTheLengthOfTheAxis) {
  EXPECT_DOUBLE_EQ(gradient_of({2.0, 0.0, 0.0}).value({0.25, 7.0, 9.0}), 0.25);
  EXPECT_DOUBLE_EQ(gradient_of({3.0, 0.0, 4.0}).value({0.5, 0.0, 0.5}), 0.7);
}

TEST(Pattern, GradientFoldsBackOnlyValuesAboveOne) {
  const AskedPattern gradient = gradient_of({0.0, 1.0, 0.0});
  EXPECT_EQ(gradient.value({0.0, 1.0, 0.0}), 1.0);
  EXPECT_NEAR(gradient.value({0.0, 2.25, 0.0}), 0.25, 1e-12);
  EXPECT_EQ(gradient.value({0.0, -0.25, 0.0}), -0.25);
}

TEST(Pattern, CheckerAlternatesFromCubeToCube) {
  const AskedPattern checker(PatternKind::checker);
  EXPECT_EQ(checker.value({0.5, 0.5, 0.5}), 0.0);
  EXPECT_EQ(checker.value({1.5, 0.5, 0.5}), 1.0);
  EXPECT_EQ(checker.value({1.5, 1.5, 0.5}), 0.0);
  EXPECT_EQ(checker.value({-0.5, 0.5, 0.5}), 1.0);
  EXPECT_EQ(checker.value({-0.5, -0.5, -0.5}), 1.0);
}

TEST(Pattern, CheckerTakesPointsJustBelowABorderToTheCubeAbove) {
  const AskedPattern checker(PatternKind::checker);
  EXPECT_EQ(checker.value({0.5, -1e-11, 0.5}), checker.value({0.5, 0.0, 0.5}));
  EXPECT_NE(checker.value({0.5, -1e-9, 0.5}), checker.value({0.5, 0.0, 0.5}));
}

TEST(Pigment, SolidColorIsTheSameEverywhere) {
  Pigment pigment;
  pigment.color = {{0.2f, 0.4f, 0.6f}, 0.5f, 0.25f};
  const FilteredColor color = color_at(pigment, {1.0, -2.0, 3.0});
  EXPECT_EQ(color.rgb, Rgb(0.2f, 0.4f, 0.6f));
  EXPECT_EQ(color.filter, 0.5f);
  EXPECT_EQ(color.transmit, 0.25f);
}

TEST(Pigment, WaveFormsHaveTheirFormulas) {
  EXPECT_NEAR(level_at(ramp({WaveForm::ramp}), 0.3), 0.3, 1e-6);
  EXPECT_NEAR(level_at(ramp({WaveForm::triangle}), 0.3), 0.6, 1e-6);
  EXPECT_NEAR(level_at(ramp({WaveForm::triangle}), 0.8), 0.4, 1e-6);
  EXPECT_NEAR(level_at(ramp({WaveForm::sine}), 0.25), 1.0, 1e-6);
  EXPECT_NEAR(level_at(ramp({WaveForm::sine}), 0.75), 0.0, 1e-6);
  EXPECT_NEAR(level_at(ramp({WaveForm::scallop}), 0.5), 1.0, 1e-6);
  EXPECT_NEAR(level_at(ramp({WaveForm::scallop}), 0.25), std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(level_at(ramp({WaveForm::cubic}), 0.25), 0.0625 * 2.5, 1e-6);
  EXPECT_NEAR(level_at(ramp({WaveForm::poly, 3.0}), 0.5), 0.125, 1e-6);
}

TEST(Pigment, FrequencyAndPhaseStretchAndShift) {
  EXPECT_NEAR(level_at(ramp({WaveForm::ramp, 1.0, 3.0, 0.0}), 0.5), std::fmod(1.5, 1.00001), 1e-6);
  EXPECT_NEAR(level_at(ramp({WaveForm::ramp, 1.0, 1.0, 0.25}), 0.5), 0.75, 1e-6);
  EXPECT_NEAR(level_at(ramp({WaveForm::ramp, 1.0, -1.0, 0.0}), 0.25), 0.75, 1e-6) << "negative values count upwards";
  EXPECT_NEAR(level_at(ramp({WaveForm::ramp, 1.0, 0.0, 0.5}), 0.25), 0.25, 1e-6) << "no frequency: neither counts";
}

TEST(Pigment, NegativeWayContinuesTheRampBelowZero) {
  EXPECT_NEAR(level_at(ramp({}), -0.25), 0.75, 1e-6);
  EXPECT_NEAR(level_at(ramp({}), -3.75), 0.25, 1e-4);
}

TEST(Pigment, EndOfAUnitGradientKeepsItsLastColor) { EXPECT_EQ(level_at(ramp({}), 1.0), 1.0); }

TEST(Pigment, ColorsBeyondTheEndsOfTheMapStay) {
  Pigment pigment = ramp({});
  pigment.pattern.change().map = {{0.25, grey_of(0.5f)}, {0.75, grey_of(1.0f)}};
  EXPECT_EQ(level_at(pigment, 0.1), 0.5);
  EXPECT_EQ(level_at(pigment, 0.9), 1.0);
  EXPECT_EQ(level_at(pigment, 0.5), 0.75);
}

TEST(Pigment, EntriesAtOnePositionMakeAnEdge) {
  Pigment pigment = ramp({});
  pigment.pattern.change().map = {
      {0.0, grey_of(0.0f)}, {0.5, grey_of(0.5f)}, {0.5, grey_of(1.0f)}, {1.0, grey_of(1.0f)}};
  EXPECT_EQ(level_at(pigment, 0.25), 0.25);
  EXPECT_EQ(level_at(pigment, 0.5), 0.5) << "the edge itself belongs to the range below";
  EXPECT_EQ(level_at(pigment, 0.50001), 1.0);
}

TEST(Pigment, MapPositionsCountInSinglePrecision) {
  // The double nearest to 0.8 lies below the float nearest to it, so 0.8 itself is not yet the last entry.
  Pigment pigment = ramp({});
  pigment.pattern.change().map = {{0.0, grey_of(0.0f)}, {0.8, grey_of(0.5f)}, {0.8, grey_of(1.0f)}};
  EXPECT_LT(level_at(pigment, 0.8), 0.6);
  EXPECT_EQ(level_at(pigment, static_cast<double>(0.8f)), 1.0);
}

TEST(Pigment, FilterAndTransmitAreBlendedToo) {
  Pigment pigment = ramp({});
  pigment.pattern.change().map = {{0.0, {Rgb(0.0f), 1.0f, 0.0f}}, {1.0, {Rgb(0.0f), 0.0f, 0.5f}}};
  const FilteredColor color = color_at(pigment, {0.25, 0.0, 0.0});
  EXPECT_FLOAT_EQ(color.filter, 0.75f);
  EXPECT_FLOAT_EQ(color.transmit, 0.125f);
}

TEST(Pigment, StepsDoNotBlend) {
  Pigment pigment;
  pigment.pattern = PigmentPattern{patterned(PatternKind::checker), {{0.0, grey_of(0.25f)}, {1.0, grey_of(0.75f)}}};
  EXPECT_EQ(level_at(pigment, 0.5), 0.25);
  EXPECT_EQ(level_at(pigment, 1.5), 0.75);
}

TEST(Pigment, IsPlacedByItsTransform) {
  Pigment pigment = ramp({});
  pigment.pattern.change().warps.transform(Transform::scaling({2.0, 1.0, 1.0}));
  pigment.pattern.change().warps.transform(Transform::translation({10.0, 0.0, 0.0}));
  EXPECT_NEAR(level_at(pigment, 11.0), 0.5, 1e-6);
}

TEST(Pigment, AnswersForPointsThatAreNoNumbers) {
  Pigment pigment;
  pigment.pattern = PigmentPattern{patterned(PatternKind::checker), {{0.0, grey_of(0.25f)}, {1.0, grey_of(0.75f)}}};
  for (const double x : {HUGE_VAL, -HUGE_VAL, std::numeric_limits<double>::quiet_NaN()}) {
    const double level = level_at(pigment, x);
    EXPECT_TRUE(level == 0.25 || level == 0.75);
    EXPECT_GE(level_at(ramp({}), x), 0.0);
  }
  EXPECT_EQ(level_at(ramp({}), std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(Opacity, DependsOnEveryColorOfTheMap) {
  Pigment pigment = ramp({});
  EXPECT_FALSE(lets_light_through(pigment));
  pigment.color.transmit = 1.0f;
  EXPECT_FALSE(lets_light_through(pigment)) << "the plain colour of a patterned pigment does not show";
  pigment.pattern.change().map[1].color.filter = 0.01f;
  EXPECT_TRUE(lets_light_through(pigment));
}

TEST(Opacity, OneOpaqueLayerMakesTheTextureOpaque) {
  TextureLayer clear;
  clear.pigment.color.transmit = 1.0f;
  EXPECT_FALSE(is_opaque(Texture{{clear}}));
  EXPECT_FALSE(is_opaque(Texture{{clear, clear}}));
  EXPECT_TRUE(is_opaque(Texture{{clear, TextureLayer()}}));
  EXPECT_TRUE(is_opaque(Texture{{TextureLayer(), clear}}));
  EXPECT_FALSE(is_opaque(Texture()));
}

}  // namespace
}  // namespace firstlight::render
