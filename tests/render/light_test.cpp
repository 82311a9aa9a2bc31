#include "render/light/light.h"

#include <gtest/gtest.h>

namespace firstlight::render {
namespace {

Light light_at(const Vec3& position) {
  Light light;
  light.position = position;
  light.color = {1.0f, 0.5f, 0.25f};
  return light;
}

TEST(Light, HasItsColorAtTheFadeDistance) {
  Light light = light_at({0.0, 10.0, 0.0});
  light.fade_distance = 10.0;
  light.fade_power = 2.0;
  EXPECT_TRUE(fades(light));
  EXPECT_EQ(fading(light, 10.0), 1.0);
}

TEST(Light, FadesByThePowerOfTheDistance) {
  Light light = light_at({0.0, 20.0, 0.0});
  light.fade_distance = 10.0;
  light.fade_power = 2.0;
  EXPECT_DOUBLE_EQ(fading(light, 20.0), 2.0 / 5.0);
  light.fade_power = 1.0;
  EXPECT_DOUBLE_EQ(fading(light, 20.0), 2.0 / 3.0);
  EXPECT_EQ(fading(light, 0.0), 2.0) << "at most twice as bright near by";
}

TEST(Light, DoesNotFadeWithoutPowerOrDistance) {
  Light light = light_at({0.0, 20.0, 0.0});
  light.fade_distance = 10.0;
  EXPECT_FALSE(fades(light));
  EXPECT_EQ(fading(light, 20.0), 1.0);
  light.fade_distance = 0.0;
  light.fade_power = 2.0;
  EXPECT_FALSE(fades(light));
  EXPECT_EQ(fading(light, 20.0), 1.0);
}

TEST(Light, MovesWithoutChangingItsFading) {
  Light light = light_at({1.0, 0.0, 0.0});
  light.fade_distance = 3.0;
  const Light moved = placed(light, Transform::scaling({2.0, 2.0, 2.0}).then(Transform::translation({0.0, 1.0, 0.0})));
  EXPECT_EQ(moved.position, Vec3(2.0, 1.0, 0.0));
  EXPECT_EQ(moved.fade_distance, 3.0);
  EXPECT_EQ(moved.color, light.color);
}

}  // namespace
}  // namespace firstlight::render
