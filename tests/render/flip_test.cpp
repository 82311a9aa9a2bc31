#include "render/image/flip.h"

#include "render/image/difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace firstlight::render {
namespace {

using Pixels = std::vector<Rgb>;

constexpr int kWidth = 48;
constexpr int kHeight = 40;

Pixels plain(const Rgb& color) { return Pixels(static_cast<std::size_t>(kWidth * kHeight), color); }

std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kWidth + x); }

/// Colours of a smooth picture with an edge in it.
Pixels example() {
  Pixels image;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float u = static_cast<float>(x) / kWidth;
      const float v = static_cast<float>(y) / kHeight;
      image.push_back(x + y < 40 ? Rgb(0.2f + 0.6f * u, 0.3f * v, 0.5f) : Rgb(0.1f, 0.2f + 0.5f * v, 0.4f * u));
    }
  }
  return image;
}

Pixels noisy(Pixels image, float amount) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> offset(-1.0f, 1.0f);
  for (Rgb& color : image) color += Rgb(offset(random), offset(random), offset(random)) * amount;
  return image;
}

double flip(const Pixels& reference, const Pixels& test) { return Flip(reference, kWidth, kHeight).mean(test); }

TEST(Flip, EqualPicturesDoNotDiffer) { EXPECT_EQ(flip(example(), example()), 0.0); }

// Without edges the measure is that of the colours alone. Black and white are 100 apart in lightness and in nothing
// else; green and blue are (87.73, -75.61, 72.98) and (32.30, 25.58, -34.84), 55.44 + 147.87 = 203.3. With the
// exponent 0.7 that is 25.119 of 41.27; the bend is at 16.51, so 0.95 + 0.05 (25.119 - 16.51) / (41.27 - 16.51).
TEST(Flip, BlackAndWhiteAreKnownOnPaper) { EXPECT_NEAR(flip(plain(Rgb(0.0f)), plain(Rgb(1.0f))), 0.96739, 2e-4); }

TEST(Flip, GreenAndBlueAreTheMostThatIsReckonedWith) {
  EXPECT_NEAR(flip(plain(Rgb(0.0f, 1.0f, 0.0f)), plain(Rgb(0.0f, 0.0f, 1.0f))), 1.0, 1e-5);
}

// L* of a grey of linear light 0.2 is 116 cbrt(0.2) - 16 = 51.8372, of 0.25 57.0754: 5.2382 apart, to the power of 0.7
// 3.1880, and below the bend a share of it, 0.95 / 16.51 of 3.1880.
TEST(Flip, SmallDifferencesAreBelowTheBend) {
  EXPECT_NEAR(flip(plain(Rgb(0.2f)), plain(Rgb(0.25f))), 0.95 / 16.51 * 3.1880, 2e-4);
}

// In the dark the Hunt adjustment leaves little of a difference in hue: it is L* / 100 of it.
TEST(Flip, HueMattersLessInTheDark) {
  const double bright = flip(plain({0.8f, 0.6f, 0.6f}), plain({0.6f, 0.675f, 0.6f}));
  const double dark = flip(plain({0.08f, 0.06f, 0.06f}), plain({0.06f, 0.0675f, 0.06f}));
  EXPECT_LT(dark, 0.6 * bright);
}

TEST(Flip, IsSymmetric) {
  const Pixels changed = noisy(example(), 0.2f);
  EXPECT_NEAR(flip(example(), changed), flip(changed, example()), 1e-7);
}

TEST(Flip, GrowsWithTheNoise) {
  double before = 0.0;
  for (const float amount : {0.01f, 0.03f, 0.1f, 0.3f}) {
    const double now = flip(example(), noisy(example(), amount));
    EXPECT_GT(now, 1.2 * before);
    before = now;
  }
  EXPECT_LT(before, 1.0);
}

// A checkerboard of single pixels is 33 cycles a degree: next to nothing of it passes the eye's filters, so it looks
// grey.
TEST(Flip, FinePatternsLookGrey) {
  Pixels checker = plain(Rgb(0.0f));
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) checker[at(x, y)] = Rgb((x + y) % 2 == 0 ? 1.0f : 0.0f);
  }
  EXPECT_LT(flip(plain(Rgb(0.5f)), checker), 0.05);
}

// A white pixel on grey. The contrast filter leaves 0.1489 of it, 4.3601 in lightness, whose error is 0.1613 by its
// colour. The point filter answers with 0.5 * 0.2990 * 0.1453 = 0.0217 in both directions, which raises that to the
// power of 1 - sqrt(0.0217).
TEST(Flip, PointsAreSeen) {
  Pixels dotted = plain(Rgb(0.5f));
  dotted[at(20, 20)] = Rgb(1.0f);
  const std::vector<float> map = Flip(plain(Rgb(0.5f)), kWidth, kHeight).map(dotted);
  EXPECT_NEAR(map[at(20, 20)], 0.2111, 2e-4);
  EXPECT_GT(map[at(20, 20)], map[at(22, 20)]);
  EXPECT_EQ(map[at(40, 20)], 0.0f) << "twenty pixels away nothing is seen of it";
}

// The measure has no preferred direction.
TEST(Flip, TurnsWithThePicture) {
  const int size = 32;
  Pixels upright(size * size, Rgb(0.2f));
  for (int y = 0; y < size; ++y) upright[static_cast<std::size_t>(y * size + 12)] = Rgb(0.9f, 0.3f, 0.1f);
  Pixels lying(size * size, Rgb(0.2f));
  for (int x = 0; x < size; ++x) lying[static_cast<std::size_t>(12 * size + x)] = Rgb(0.9f, 0.3f, 0.1f);
  const Pixels grey(size * size, Rgb(0.2f));
  const Flip flip(grey, size, size);
  EXPECT_NEAR(flip.mean(upright), flip.mean(lying), 1e-6);
  EXPECT_GT(flip.mean(upright), 0.05);
}

TEST(Flip, FewerPixelsADegreeBlurLess) {
  Pixels dotted = plain(Rgb(0.5f));
  dotted[at(20, 20)] = Rgb(1.0f, 0.5f, 0.5f);
  const Pixels grey = plain(Rgb(0.5f));
  EXPECT_GT(Flip(grey, kWidth, kHeight, 20.0).map(dotted)[at(20, 20)],
            Flip(grey, kWidth, kHeight, 67.0).map(dotted)[at(20, 20)]);
}

TEST(Flip, TakesAnyColourAndAnySize) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const Pixels wild{Rgb(nan, -3.0f, infinity), Rgb(-infinity, 7.0f, nan)};
  const Pixels shown{Rgb(0.0f, 0.0f, 1.0f), Rgb(0.0f, 1.0f, 0.0f)};
  EXPECT_EQ(Flip(shown, 2, 1).mean(wild), 0.0);
  EXPECT_EQ(Flip(shown, 1, 2).mean(wild), 0.0);
  EXPECT_EQ(Flip({}, 0, 0).mean({}), 0.0);
}

TEST(MeanAbsoluteDifference, IsTheMeanOverPixelsAndChannels) {
  const Pixels a{Rgb(0.5f, 0.25f, 0.0f), Rgb(1.0f, 1.0f, 1.0f)};
  const Pixels b{Rgb(0.25f, 0.5f, 0.0f), Rgb(1.0f, 0.0f, 1.0f)};
  EXPECT_DOUBLE_EQ(mean_absolute_difference(a, b), (0.25 + 0.25 + 1.0) / 6.0);
}

TEST(MeanAbsoluteDifference, SeesWhatADisplayShows) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(mean_absolute_difference(Pixels{Rgb(1.0f, -2.0f, nan)}, Pixels{Rgb(9.0f, 0.0f, 0.0f)}), 0.0);
}

TEST(RemainingDifference, IsOneForBlackAndNoneAtTheEnd) {
  const Pixels finished = example();
  const RemainingDifference remaining(finished);
  EXPECT_DOUBLE_EQ(remaining(plain(Rgb(0.0f))), 1.0);
  EXPECT_EQ(remaining(finished), 0.0);
  Pixels half = finished;
  for (Rgb& color : half) color *= 0.5f;
  EXPECT_NEAR(remaining(half), 0.5, 1e-6);
}

TEST(RemainingDifference, ABlackFinishedPictureHasNoUnit) {
  const Pixels black = plain(Rgb(0.0f));
  const RemainingDifference remaining(black);
  EXPECT_EQ(remaining(black), 0.0);
  EXPECT_EQ(remaining(plain(Rgb(0.1f))), 1.0);
}

}  // namespace
}  // namespace firstlight::render
