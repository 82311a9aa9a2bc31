#include "render/trace/ray_task.h"

#include <gtest/gtest.h>

#include <random>

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
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    EXPECT_EQ(PackedDirection(axis).unpack(), axis);
  }
}

TEST(PackedDirection, LengthDoesNotMatter) {
  const PackedDirection unit(Vec3(0.6, 0.0, -0.8));
  const PackedDirection longer(Vec3(6.0, 0.0, -8.0));
  EXPECT_LT((unit.unpack() - longer.unpack()).length(), 1e-9);
}

TEST(RayTask, AFeelerKeepsItsLightWhereARayKeepsItsDirection) {
  RayTask feeler;
  feeler.set_light(70000);
  EXPECT_EQ(feeler.light(), 70000u);
}

}  // namespace
}  // namespace firstlight::render
