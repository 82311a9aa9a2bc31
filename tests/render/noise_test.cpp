// The expected numbers are what POV-Ray 3.7 prints with 17 decimals, so agreement is to the last bit.
#include "render/math/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace firstlight::render {
namespace {

struct Expected {
  Vec3 point;
  double original, corrected, gradient;  // generators 1, 2, 3
  Vec3 vector;
};

const Expected kExpected[] = {
    {{0.3, 0.4, 0.5},
     0.41903169558950404,
     0.47587126693338683,
     0.67807530508139957,
     {-0.08096830441049599, -0.17055074300735987, -0.18629602327616002}},
    {{-0.3, -10.4, 7.25},
     0.26057500471300021,
     0.39825033468959053,
     0.52379604072452168,
     {-0.23942499528699976, 0.11384235816560009, 0.10235474754249974}},
    {{1, 2, 3},
     0.30699650000000001,
     0.42099017432902996,
     0.47158530531659565,
     {-0.19300349999999999, -0.45718300000000001, 0.47407500000000002}},
    {{1234.567, -98.25, 1e7 + 0.375},
     0.77972048310627073,
     0.65255676870721835,
     0.53918971190509235,
     {0.27972048310627079, -0.23750438990417005, 0.27452003251246915}},
    {{-1e5, 0.125, 4095.875},
     0.44334586330890652,
     0.48778170349919231,
     0.57867960113822803,
     {-0.05665413669109345, 0.13772878476905820, -0.49883039941596985}},
};

TEST(Noise, IsPovRaysToTheLastBit) {
  for (const Expected& e : kExpected) {
    EXPECT_EQ(noise(e.point, 1), e.original) << e.point;
    EXPECT_EQ(noise(e.point, 2), e.corrected) << e.point;
    EXPECT_EQ(noise(e.point, 3), e.gradient) << e.point;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(dnoise(e.point)[axis], e.vector[axis], 1e-17) << e.point;
  }
}

TEST(Noise, TurbulenceOfOneOctaveIsNoise) {
  const Vec3 point(0.3, -0.4, 12.5);
  EXPECT_EQ(turbulence(point, {1, 2.0f, 0.5f}, 1), noise(point, 1));
  EXPECT_EQ(dturbulence(point, {1, 2.0f, 0.5f}), dnoise(point));
}

TEST(Noise, TurbulenceAddsOctaves) {
  const Vec3 sum = dturbulence(Vec3(0.3, -0.4, 12.5), {4, 2.1f, 0.6f});
  EXPECT_EQ(sum, Vec3(-0.20624035643341282, -0.32905604972012975, 0.10521228017287790));
  const Vec3 point(0.3, 0.4, 0.5);
  EXPECT_EQ(turbulence(point, {2, 2.0f, 0.5f}, 1), noise(point, 1) + 0.5 * noise(point * 2.0, 1));
  EXPECT_EQ(turbulence(point, {2, 2.0f, 0.5f}, 2),
            2.0 * noise(point, 2) - 0.5 + 0.5 * (2.0 * noise(point * 2.0, 2) - 0.5));
}

TEST(Noise, FarPointsAndWhatIsNoNumberAreSafe) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (int generator = 0; generator < 4; ++generator) {
    EXPECT_EQ(noise(Vec3(3e9, 0.5, 0.5), generator), 1.0);
    noise(Vec3(infinite, -infinite, std::nan("")), generator);
  }
  dnoise(Vec3(-1e300, infinite, std::nan("")));
}

}  // namespace
}  // namespace firstlight::render
