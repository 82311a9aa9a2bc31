#include "render/light/spectrum.h"

#include <gtest/gtest.h>

namespace firstlight::render {
namespace {

TEST(Spectrum, BandsTogetherAreNearlyWhite) {
  for (const int count : {2, 3, 7, 50}) {
    Rgb sum(0.0f);
    for (int number = 0; number < count; ++number) {
      sum += hue({static_cast<std::uint16_t>(number), static_cast<std::uint16_t>(count)}) / static_cast<float>(count);
    }
    for (const float channel : {sum.x, sum.y, sum.z}) {
      EXPECT_LE(channel, 1.0f + 1e-6f);
      EXPECT_GE(channel, 0.98f) << count;
    }
  }
}

TEST(Spectrum, VioletIsBentMostAndTheMiddleAsMatterIs) {
  EXPECT_NEAR(dispersed_ior(1.5, 1.2, {1, 3}), 1.5, 1e-12);
  EXPECT_GT(dispersed_ior(1.5, 1.2, {0, 3}), 1.5);
  EXPECT_LT(dispersed_ior(1.5, 1.2, {2, 3}), 1.5);
  EXPECT_NEAR(dispersed_ior(1.0, 1.2, {0, 1000}) / dispersed_ior(1.0, 1.2, {999, 1000}), 1.2, 1e-3);
}

}  // namespace
}  // namespace firstlight::render
