// Values of patterns. The expected ones are what POV-Ray 3.7 gives for `function { pattern { ... frequency 0 } }`.
#include "render/texture/patterns.h"

#include "render/texture/patterning.h"
#include "tests/render/pattern_test_support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace firstlight::render {
namespace {

using Values = std::array<double, 4>;

constexpr std::array<std::array<double, 3>, 4> kPoints = {
    {{0.3, 0.4, -0.2}, {-0.7, 0.15, 0.6}, {1.4, -2.3, 0.9}, {-3.6, 5.2, -7.1}}};

void expect_values(PatternKind kind, const PatternParameters& parameters, const Values& expected) {
  const AskedPattern pattern(kind, parameters);
  Wave wave;
  wave.frequency = 0.0;
  ASSERT_TRUE(pattern.is_made()) << spelling(kind);
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    Column<double> value;
    value[0] = pattern.value({kPoints[i][0], kPoints[i][1], kPoints[i][2]});
    shape_all(wave, 1, value);
    EXPECT_NEAR(value[0], expected[i], 1e-9 * std::max(1.0, std::abs(expected[i]))) << spelling(kind) << " at point " << i;
  }
}

FractalParameters mandel(int iterations, int exponent = 2) {
  FractalParameters fractal;
  fractal.iterations = iterations;
  fractal.exponent = exponent;
  return fractal;
}

FractalParameters julia(Vec2 start, int iterations, int exponent = 2) {
  FractalParameters fractal = mandel(iterations, exponent);
  fractal.julia = true;
  fractal.start = start;
  return fractal;
}

TEST(PatternValues, AboutTheOrigin) {
  expect_values(PatternKind::boxed, {}, {0.6, 0.3, 0.0, 0.0});
  expect_values(PatternKind::cylindrical, {}, {0.639444872453601, 0.078045554270711, 0.0, 0.0});
  expect_values(PatternKind::planar, {}, {0.6, 0.85, 0.0, 0.0});
  expect_values(PatternKind::spherical, {}, {0.461483519286550, 0.065922915386530, 0.0, 0.0});
  expect_values(PatternKind::onion, {}, {0.538516480713450, 0.934077084613470, 0.839013913315678, 0.508417323613852});
  expect_values(PatternKind::radial, {}, {1.093583520905499, 0.612781374013901, 0.909068815910812, 0.324685928312435});
}

TEST(PatternValues, OfWavesAndBulges) {
  expect_values(PatternKind::leopard, {}, {0.026273083616051, 0.000542314155515, 0.116297238404726, 0.152074846703314});
  expect_values(PatternKind::quilted, QuiltedParameters{0.3, 1.7},
                {0.145751597745664, 0.178578452159319, 0.214865876615784, 0.274872107633122});
}

TEST(PatternValues, OfSpiralsAndGrain) {
  expect_values(PatternKind::marble, {}, {0.3, 0.3, 1.4, 0.4});
  expect_values(PatternKind::wood, {}, {0.5, 0.715891053163818, 2.692582403567252, 6.324555320336759});
  expect_values(PatternKind::spiral1, SpiralParameters{3},
                {1.492750852951300, 3.465101410855384, 3.853654844132286, 1.013681599763709});
  expect_values(PatternKind::spiral2, SpiralParameters{-2},
                {1.990334470601733, 0.802049597600151, 1.451903412579954, 0.712719575444437});
}

TEST(PatternValues, OfCells) {
  expect_values(PatternKind::brick, BrickParameters(), {1, 1, 1, 1});
  expect_values(PatternKind::cubic, {}, {1, 3, 4, 5});
  expect_values(PatternKind::hexagon, {}, {0, 2, 2, 2});
}

TEST(PatternValues, OfMandelbrotsSets) {
  FractalParameters square = mandel(30);
  square.exterior_type = 6;
  square.exterior_factor = 0.5;
  expect_values(PatternKind::mandel, square, {1.0, 1.0, 4.475279320891602, 18.384776310850238});
  FractalParameters cube = mandel(25, 3);
  cube.interior_type = 1;
  expect_values(PatternKind::mandel, cube, {0.408252522680988, 0.08, 0.0, 0.0});
  expect_values(PatternKind::mandel, mandel(20, 5), {1.0, 1.0, 0.0, 0.0});
}

TEST(PatternValues, OfJuliasSets) {
  expect_values(PatternKind::julia, julia({0.35, 0.3}, 30), {1.0, 0.1, 0.0, 0.0});
  FractalParameters fourth = julia({0.4, 0.2}, 9, 4);
  fourth.interior_type = 3;
  fourth.interior_factor = 0.7;
  expect_values(PatternKind::julia, fourth, {0.161755193233669, 0.161677523476199, 0.0, 0.0});
}

TEST(PatternValues, OfMagnets) {
  FractalParameters first = mandel(12, 0);
  first.magnet = 1;
  expect_values(PatternKind::magnet, first, {1.0, 1.0 / 3.0, 5.0 / 12.0, 1.0 / 6.0});
  FractalParameters second = first;
  second.magnet = 2;
  second.interior_type = 1;
  second.interior_factor = 0.001;
  expect_values(PatternKind::magnet, second, {0.000393158155677, 1.0 / 6.0, 1.0 / 6.0, 1.0 / 12.0});
  FractalParameters set = julia({1.2, 0.3}, 10, 0);
  set.magnet = 1;
  set.exterior_type = 4;
  set.exterior_factor = 0.001;
  expect_values(PatternKind::magnet, set, {1.0, 1.0, 1.0, 3938.799284318421087});
  set = julia({1.5, 0.4}, 10, 0);
  set.magnet = 2;
  expect_values(PatternKind::magnet, set, {1.0, 0.4, 0.7, 1.0});
}

}  // namespace
}  // namespace firstlight::render
