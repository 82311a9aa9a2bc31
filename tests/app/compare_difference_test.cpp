#include "app/compare/difference.h"

#include "app/compare/record_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace firstlight::app::compare {
namespace {

using render::Picture;

Picture grey(int width, int height, std::uint8_t value) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), value)};
}

TEST(CompareDifference, EqualPicturesAgreeEverywhere) {
  const PictureDifference found = difference(grey(10, 10, 80), grey(10, 10, 80));
  EXPECT_EQ(found.share, 1.0);
  EXPECT_EQ(found.mean, 0.0);
  EXPECT_EQ(found.rms, 0.0);
  EXPECT_TRUE(std::isinf(found.psnr));
  EXPECT_TRUE(std::isinf(found.psnr_8x8));
  EXPECT_EQ(found.flip, 0.0);
  EXPECT_EQ(found.worst, 0);
}

TEST(CompareDifference, TwoStepsAgreeAndThreeDoNot) {
  Picture changed = grey(10, 10, 80);
  changed.rgb[0] = 82;
  EXPECT_EQ(difference(grey(10, 10, 80), changed).share, 1.0);
  changed.rgb[0] = 83;
  EXPECT_DOUBLE_EQ(difference(grey(10, 10, 80), changed).share, 0.99);
}

TEST(CompareDifference, FindsTheWorstPixel) {
  Picture changed = grey(10, 10, 80);
  changed.rgb[3 * (4 * 10 + 7) + 1] = 200;
  changed.rgb[3 * (5 * 10 + 2)] = 90;
  const PictureDifference found = difference(grey(10, 10, 80), changed);
  EXPECT_EQ(found.worst, 120);
  EXPECT_EQ(found.x, 7);
  EXPECT_EQ(found.y, 4);
  EXPECT_EQ(found.first, (std::vector<int>{80, 80, 80}));
  EXPECT_EQ(found.second, (std::vector<int>{80, 200, 80}));
}

TEST(CompareDifference, MeanAndRmsAreOfAllChannels) {
  // One channel of 300 is 30 apart: mean 30 / 300, mean square 900 / 300.
  Picture changed = grey(10, 10, 80);
  changed.rgb[17] = 110;
  const PictureDifference found = difference(grey(10, 10, 80), changed);
  EXPECT_NEAR(found.mean, 0.1, 1e-12);
  EXPECT_NEAR(found.rms, std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(found.psnr, 10.0 * std::log10(255.0 * 255.0 / 3.0), 1e-9);
}

TEST(CompareDifference, PsnrOfOneStepEverywhere) {
  // Mean squared difference 1: 20 log10(255) dB; the means are as far apart.
  const PictureDifference found = difference(grey(10, 10, 80), grey(10, 10, 81));
  EXPECT_NEAR(found.psnr, 48.1308, 1e-4);
  EXPECT_NEAR(found.psnr_8x8, 48.1308, 1e-4);
}

TEST(CompareDifference, GrainVanishesInTheMeansOfBlocks) {
  // Up and down by 10 in turn: no pixel agrees, every block of 8x8 has the same mean.
  Picture grainy = grey(16, 16, 80);
  for (std::size_t pixel = 0; pixel < 256; ++pixel) {
    for (std::size_t c = 0; c < 3; ++c) grainy.rgb[3 * pixel + c] = pixel % 2 == 0 ? 70 : 90;
  }
  const PictureDifference found = difference(grey(16, 16, 80), grainy);
  EXPECT_EQ(found.share, 0.0);
  EXPECT_NEAR(found.psnr, 28.1308, 1e-4);
  EXPECT_TRUE(std::isinf(found.psnr_8x8));
  EXPECT_EQ(judge(found, {}), Status::warns);
}

TEST(CompareDifference, BlocksAtTheBorderCountForTheirPixels) {
  // The last column of 9x8 pixels is a block of its own: 8 of 72 pixels are 9 apart, mean square 81 / 9.
  Picture changed = grey(9, 8, 80);
  for (std::size_t y = 0; y < 8; ++y) {
    for (std::size_t c = 0; c < 3; ++c) changed.rgb[3 * (9 * y + 8) + c] = 89;
  }
  const PictureDifference found = difference(grey(9, 8, 80), changed);
  EXPECT_NEAR(found.psnr_8x8, 10.0 * std::log10(255.0 * 255.0 / 9.0), 1e-9);
  EXPECT_NEAR(found.psnr_8x8, found.psnr, 1e-9);
}

TEST(CompareDifference, FlipOfBlackAndWhiteIsOne) {
  EXPECT_GT(difference(grey(64, 64, 0), grey(64, 64, 255)).flip, 0.9);
  EXPECT_LT(difference(grey(64, 64, 80), grey(64, 64, 82)).flip, 0.1);
}

TEST(CompareDifference, MapShowsASingleStep) {
  EXPECT_EQ(difference_map(grey(2, 2, 80), grey(2, 2, 81)), grey(2, 2, 16));
  EXPECT_EQ(difference_map(grey(2, 2, 0), grey(2, 2, 255)), grey(2, 2, 255));
}

TEST(CompareDifference, FlipMapIsDarkWhereNothingDiffers) {
  const Picture same = flip_map(grey(4, 4, 80), grey(4, 4, 80));
  EXPECT_EQ(same.rgb[0], 0);
  EXPECT_EQ(same.rgb[1], 0);
  const Picture apart = flip_map(grey(64, 64, 0), grey(64, 64, 255));
  EXPECT_GT(apart.rgb[0], 240);
  EXPECT_GT(apart.rgb[1], 180);
}

TEST(CompareJudge, ByShareByPsnrOrByBoth) {
  PictureDifference found;
  found.share = 0.985;
  found.psnr = 33.0;
  found.psnr_8x8 = 39.0;
  EXPECT_EQ(judge(found, {}), Status::agrees);
  EXPECT_EQ(judge(found, {99.0, {}}), Status::differs);
  EXPECT_EQ(judge(found, {{}, 30.0}), Status::agrees);
  EXPECT_EQ(judge(found, {{}, 35.0}), Status::differs);
  EXPECT_EQ(judge(found, {98.0, 35.0}), Status::differs);
  EXPECT_EQ(judge(found, {98.0, 33.0}), Status::agrees);
  EXPECT_EQ(judge(found, {99.0, {}, 39.0}), Status::warns);
}

TEST(CompareRecord, RatiosArePairedByRound) {
  SceneRecord record;
  for (const double seconds : {4.0, 8.0, 6.0}) record.povray.push_back({0.0, seconds, seconds, seconds, 1000});
  for (const double seconds : {2.0, 2.0, 2.0}) record.ours.push_back({0.0, seconds, seconds, seconds, 500});
  for (const Measure& measure : measures()) {
    const std::vector<double> found = ratios(record, measure);
    if (measure.name == "parse_s") {
      EXPECT_TRUE(found.empty()) << "nothing can be divided by 0";
    } else if (measure.name == "peak_bytes") {
      EXPECT_EQ(found, (std::vector<double>{2.0, 2.0, 2.0}));
    } else {
      EXPECT_EQ(found, (std::vector<double>{2.0, 4.0, 3.0})) << measure.name;
    }
  }
  const Spread spread = spread_of(std::vector<double>{2.0, 4.0, 3.0});
  EXPECT_EQ(spread.median, 3.0);
  EXPECT_EQ(spread.least, 2.0);
  EXPECT_EQ(spread.most, 4.0);
}

}  // namespace
}  // namespace firstlight::app::compare
