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

TEST(Light, ShinesFromItsPositionWithItsFullColor) {
  const Illumination light = illuminate(light_at({3.0, 4.0, 1.0}), {0.0, 0.0, 1.0});
  EXPECT_DOUBLE_EQ(light.distance, 5.0);
  EXPECT_DOUBLE_EQ(light.direction.x, 0.6);
  EXPECT_DOUBLE_EQ(light.direction.y, 0.8);
  EXPECT_EQ(light.direction.z, 0.0);
  EXPECT_EQ(light.color, Rgb(1.0f, 0.5f, 0.25f));
}

TEST(Light, HasItsColorAtTheFadeDistance) {
  Light light = light_at({0.0, 10.0, 0.0});
  light.fade_distance = 10.0;
  light.fade_power = 2.0;
  EXPECT_EQ(illuminate(light, {0.0, 0.0, 0.0}).color, light.color);
}

TEST(Light, FadesByThePowerOfTheDistance) {
  Light light = light_at({0.0, 20.0, 0.0});
  light.fade_distance = 10.0;
  light.fade_power = 2.0;
  EXPECT_FLOAT_EQ(illuminate(light, {0.0, 0.0, 0.0}).color.x, 2.0f / 5.0f);
  light.fade_power = 1.0;
  EXPECT_FLOAT_EQ(illuminate(light, {0.0, 0.0, 0.0}).color.x, 2.0f / 3.0f);
  EXPECT_FLOAT_EQ(illuminate(light, {0.0, 20.0, 0.0}).color.x, 2.0f) << "at most twice as bright near by";
}

TEST(Light, DoesNotFadeWithoutPowerOrDistance) {
  Light light = light_at({0.0, 20.0, 0.0});
  light.fade_distance = 10.0;
  EXPECT_EQ(illuminate(light, {0.0, 0.0, 0.0}).color, light.color);
  light.fade_distance = 0.0;
  light.fade_power = 2.0;
  EXPECT_EQ(illuminate(light, {0.0, 0.0, 0.0}).color, light.color);
}

TEST(Light, HasNoDirectionInItself) {
  const Illumination light = illuminate(light_at({1.0, 2.0, 3.0}), {1.0, 2.0, 3.0});
  EXPECT_EQ(light.distance, 0.0);
  EXPECT_EQ(light.direction, Vec3(0.0, 0.0, 0.0));
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
