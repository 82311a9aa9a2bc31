#include "render/trace/veil.h"

#include "render/surface/sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace firstlight::render {
namespace {

const Ray kForward{{0, 0, 0}, {0, 0, 1}};

Veil across(const Veils& veils, const Ray& ray, double depth) {
  RayColumns rays;
  rays.origin.set(0, ray.origin);
  rays.direction.set(0, ray.direction);
  Column<double> depths;
  depths[0] = depth;
  Veil veil;
  veils.across(1, 1, rays, depths, {&veil, 1});
  return veil;
}

Fog fog_of(double distance, const Rgb& color) {
  Fog fog;
  fog.distance = distance;
  fog.color.rgb = color;
  return fog;
}

TEST(Veil, FogTakesAndGivesByTheWay) {
  Scene scene;
  EXPECT_TRUE(Veils(scene).empty());
  scene.atmosphere.fogs = {fog_of(10.0, Rgb(0.5f, 1.0f, 0.0f)), fog_of(0.0, Rgb(1.0f))};
  const Veil veil = across(Veils(scene), kForward, 20.0);
  const float left = std::exp(-2.0f);
  EXPECT_NEAR(veil.kept.x, left, 1e-6);
  EXPECT_NEAR(veil.added.x, 0.5f * (1.0f - left), 1e-6);
  EXPECT_NEAR(veil.added.y, 1.0f - left, 1e-6);
  EXPECT_EQ(veil.added.z, 0.0f);
}

TEST(Veil, SeveralFogsMultiplyAndAdd) {
  Scene scene;
  scene.atmosphere.fogs = {fog_of(10.0, Rgb(1.0f)), fog_of(5.0, Rgb(0.5f))};
  const Veil veil = across(Veils(scene), kForward, 10.0);
  EXPECT_NEAR(veil.kept.x, std::exp(-3.0), 1e-6);
  EXPECT_NEAR(veil.added.x, 1.0 - std::exp(-1.0) + 0.5 * (1.0 - std::exp(-2.0)), 1e-6);
}

TEST(Veil, GroundFogIsThinAbove) {
  Scene scene;
  Fog fog = fog_of(1.0, Rgb(1.0f));
  fog.type = Fog::kGround;
  fog.altitude = 1.0;
  scene.atmosphere.fogs = {fog};
  const Veils veils(scene);
  EXPECT_NEAR(across(veils, {{0, -5, 0}, {0, 0, 1}}, 2.0).kept.x, std::exp(-2.0), 1e-6);
  EXPECT_NEAR(across(veils, {{0, 3, 0}, {0, 0, 1}}, 2.0).kept.x, std::exp(-0.2), 1e-6);
  EXPECT_NEAR(across(veils, {{0, 0, 0}, {0, 1, 0}}, 1.0).kept.x, std::exp(-std::atan(1.0)), 1e-6);
}

TEST(Veil, RainbowShowsAtItsAngleOnly) {
  Scene scene;
  Rainbow bow;
  bow.direction = {0, 0, 1};
  bow.angle = 45.0;
  bow.width = 10.0;
  bow.distance = 1.0;
  bow.colors = {{0.0, {Rgb(1.0f, 0.0f, 0.0f), 0.0f, 0.0f}}};
  scene.atmosphere.rainbows = {bow};
  const Veils veils(scene);
  EXPECT_EQ(across(veils, kForward, 100.0).kept.x, 1.0f);
  const Veil veil = across(veils, {{0, 0, 0}, Vec3(0, 1, 1).normalized()}, 100.0);
  EXPECT_NEAR(veil.kept.x, 0.0, 1e-6);
  EXPECT_NEAR(veil.added.x, 1.0, 1e-6);
}

TEST(Sky, LayersLieOverTheBackground) {
  Scene scene;
  scene.settings.background = Rgb(0.8f);
  SkySphere sphere;
  Pigment below, above;
  below.color = {Rgb(0.4f), 0.0f, 0.5f};
  above.color = {Rgb(1.0f, 0.0f, 0.0f), 0.0f, 0.5f};
  sphere.pigments = {below, above};
  scene.atmosphere.sky_sphere = std::make_shared<const SkySphere>(sphere);
  const Sky sky(scene, PatternWorld());
  EXPECT_FALSE(sky.is_even());
  Columns3<double> directions;
  directions.set(0, Vec3(0, 1, 0));
  Columns3<float> colors;
  sky.colors(directions, 1, sky.background(), colors);
  EXPECT_NEAR(colors.vector(0).x, 0.5 + 0.5 * (0.2 + 0.5 * 0.8), 1e-6);
  EXPECT_NEAR(colors.vector(0).y, 0.5 * (0.2 + 0.5 * 0.8), 1e-6);
}

}  // namespace
}  // namespace firstlight::render
