// Lights when a scene is frozen: their groups, what they look like, what they are projected through.

#include "render/scene/scene_builder.h"
#include "render/shape/primitives.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

Object ball(double x) {
  Object object;
  object.shape = make_sphere({x, 0.0, 0.0}, 1.0);
  return object;
}

Object lamp(const Light& light = {}) {
  Object object;
  object.kind = Object::Kind::light;
  object.extras.change().light = light;
  return object;
}

Object group_of(std::vector<Object> members, bool light_group = true, bool global_lights = false) {
  Object object;
  object.kind = Object::Kind::union_;
  object.extras.change().light_group = light_group;
  object.extras.change().global_lights = global_lights;
  object.children = std::make_shared<const std::vector<Object>>(std::move(members));
  return object;
}

std::unique_ptr<const Scene> lit_scene(const std::vector<Object>& objects) {
  SceneBuilder builder;
  auto texture = std::make_shared<Texture>();
  texture->layers.push_back({});
  for (const Object& object : objects) builder.add(object, texture);
  return builder.build();
}

/// Whether each light shines on each part: a row a light, a character a part.
std::vector<std::string> shine_in(const Scene& scene) {
  std::vector<std::string> rows;
  for (const Light& light : scene.lights) {
    std::string& row = rows.emplace_back();
    for (const Part& part : scene.parts) row += shines_on(light, part) ? 'x' : '.';
  }
  return rows;
}

TEST(LightGroup, LightsShineOnItsMembersOnly) {
  const auto scene = lit_scene({lamp(), ball(0), group_of({lamp(), ball(1), group_of({ball(2)}, false)}),
                                group_of({ball(3), lamp()}, true, true), ball(4)});
  // The ball at 0, three in groups, the ball at 4.
  EXPECT_EQ(shine_in(*scene), (std::vector<std::string>{"x..xx", ".xx..", "...x."}));
}

TEST(LightGroup, OfNestedOnesTheInnermostHasTheLightsAndTheOutermostTheRule) {
  const auto scene = lit_scene(
      {lamp(), group_of({lamp(), group_of({lamp(), ball(0)}, true, true), group_of({ball(1)}, true, true), ball(2)})});
  EXPECT_EQ(shine_in(*scene), (std::vector<std::string>{"...", ".xx", "x.."}));
}

TEST(LightGroup, LightsInAUnionWithinAreTheScenes) {
  const auto scene = lit_scene({group_of({group_of({lamp(), lamp()}, false), ball(0)}, true, true), ball(1)});
  EXPECT_EQ(shine_in(*scene), (std::vector<std::string>{"xx", "xx"}));
}

TEST(LooksLike, IsASolidInWhichNothingBeginsAndWhichCastsNoShadow) {
  Light light;
  light.position = {0.0, 3.0, 0.0};
  auto look = ball(0.0);
  look.no_shadow = true;
  place(look, Transform::translation(light.position));
  light.looks_like = std::make_shared<const Object>(std::move(look));
  Object moved = lamp(light);
  place(moved, Transform::translation({5.0, 0.0, 0.0}));
  const auto scene = lit_scene({moved, ball(9.0)});
  ASSERT_EQ(scene->solids.size(), 2u);
  const Solid& solid = scene->solids[0];
  EXPECT_EQ(solid.hidden_from, kHiddenFromShadow);
  EXPECT_EQ(solid.matter, Solid::kNoMatter);
  EXPECT_TRUE(solid.inside({5.0, 3.5, 0.0}));
  EXPECT_EQ(scene->lights[0].position, Vec3(5.0, 3.0, 0.0));
}

TEST(ProjectedThrough, IsAWindowAndNoSolid) {
  Light light;
  light.projected_through = std::make_shared<const Object>(ball(2.0));
  const auto scene = lit_scene({lamp(), lamp(light), ball(9.0)});
  EXPECT_EQ(scene->solids.size(), 1u);
  ASSERT_EQ(scene->windows.size(), 1u);
  EXPECT_EQ(scene->lights[0].window, Light::kNoWindow);
  EXPECT_EQ(scene->lights[1].window, 0u);
  EXPECT_TRUE(scene->windows[0].inside({2.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace firstlight::render
