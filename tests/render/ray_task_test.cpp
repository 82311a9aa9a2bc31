#include "render/trace/ray_task.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

TEST(PackedDirection, ComesBackWithinABillionth) {
  std::mt19937 random(11);
  std::normal_distribution<double> value;
  for (int i = 0; i < 10000; ++i) {
    const Vec3 direction = Vec3(value(random), value(random), value(random)).normalized();
    EXPECT_LT((PackedDirection(direction).unpack() - direction).length(), 1.5e-9);
  }
}

TEST(PackedDirection, AxesComeBackExactly) {
  for (const Vec3& axis :
       {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    EXPECT_EQ(PackedDirection(axis).unpack(), axis);
  }
}

TEST(PackedDirection, LengthDoesNotMatter) {
  const PackedDirection unit(Vec3(0.6, 0.0, -0.8));
  const PackedDirection longer(Vec3(6.0, 0.0, -8.0));
  EXPECT_LT((unit.unpack() - longer.unpack()).length(), 1e-9);
}

TEST(RayTask, ARecordHoldsTwoFeelersOfNeighbouringLights) {
  RayTask task;
  const PackedRgb light(Rgb(0.5f, 0.25f, 0.125f));
  task.set_feeler(70000, light);
  EXPECT_EQ(task.ray_count(), 1);
  EXPECT_TRUE(task.add_feeler(70255, PackedRgb(Rgb(1.0f))));
  EXPECT_FALSE(task.add_feeler(70256, light));
  EXPECT_EQ(task.ray_count(), 2);
  std::vector<std::pair<std::uint32_t, Rgb>> feelers;
  task.for_each_feeler(
      [&](std::uint32_t index, const PackedRgb& at_stake) { feelers.emplace_back(index, at_stake.unpack()); });
  const Rgb expected(0.5f, 0.25f, 0.125f);
  EXPECT_EQ(feelers, (std::vector<std::pair<std::uint32_t, Rgb>>{{70000, expected}, {70255, Rgb(1.0f)}}));
}

TEST(RayTask, AFarLightNeedsARecordOfItsOwn) {
  RayTask task;
  task.set_feeler(2, PackedRgb(Rgb(1.0f)));
  EXPECT_FALSE(task.add_feeler(258, PackedRgb(Rgb(1.0f))));
  EXPECT_EQ(task.ray_count(), 1);
}

TEST(RayTask, KeepsWeightsToSixteenBits) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> value(-1.0f, 1.0f);
  RayTask task;
  task.set_direction(PackedDirection(Vec3(0.0, 0.6, -0.8)));
  for (int i = 0; i < 10000; ++i) {
    const Rgb weight(value(random), value(random), value(random));
    const float adc_weight = std::abs(value(random));
    task.set_weight(weight, adc_weight);
    const Rgb kept = task.weight();
    for (const auto& [is, was] : {std::pair(kept.x, weight.x), {kept.y, weight.y}, {kept.z, weight.z}}) {
      ASSERT_NEAR(is, was, std::abs(was) * 0x1p-16f);
    }
    ASSERT_EQ(task.max_weight(), max_magnitude(kept));
    ASSERT_FALSE(task.is_black());
    ASSERT_GE(task.adc_weight(), adc_weight);
    ASSERT_LE(task.adc_weight(), adc_weight * (1.0f + 0x1p-15f));
    const float adc_kept = task.adc_weight();
    task.set_weight(kept, adc_kept);
    ASSERT_EQ(task.weight(), kept);
    ASSERT_EQ(task.adc_weight(), adc_kept);
  }
  EXPECT_EQ(task.direction().unpack(), PackedDirection(Vec3(0.0, 0.6, -0.8)).unpack());
}

TEST(RayTask, KeepsSimpleWeightsExactly) {
  RayTask task;
  task.set_weight(Rgb(1.0f, 0.5f, 0.0f), 0.25f);
  EXPECT_EQ(task.weight(), Rgb(1.0f, 0.5f, 0.0f));
  EXPECT_EQ(task.adc_weight(), 0.25f);
  task.set_weight(Rgb(0.0f, -0.0f, 0.0f), 1.0f);
  EXPECT_TRUE(task.is_black());
}

TEST(PackedRgb, KeepsEachComponentToAMillionthPartOrSoOfTheLargest) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> value(-1.0f, 1.0f);
  std::uniform_int_distribution<int> exponent(-100, 100);
  for (int i = 0; i < 10000; ++i) {
    const Rgb color = Rgb(value(random), value(random), value(random)) * std::ldexp(1.0f, exponent(random));
    const Rgb kept = PackedRgb(color).unpack();
    const float tolerance = max_magnitude(color) * 0x1p-16f;
    EXPECT_NEAR(kept.x, color.x, tolerance);
    EXPECT_NEAR(kept.y, color.y, tolerance);
    EXPECT_NEAR(kept.z, color.z, tolerance);
    EXPECT_EQ(PackedRgb(kept).unpack(), kept);
  }
}

TEST(PackedRgb, WhatIsNotFiniteIsBlack) {
  EXPECT_EQ(PackedRgb(Rgb(0.0f)).unpack(), Rgb(0.0f));
  EXPECT_EQ(PackedRgb(Rgb(1.0f, std::numeric_limits<float>::infinity(), 0.0f)).unpack(), Rgb(0.0f));
  EXPECT_EQ(PackedRgb(Rgb(std::numeric_limits<float>::quiet_NaN())).unpack(), Rgb(0.0f));
}

}  // namespace
}  // namespace firstlight::render
