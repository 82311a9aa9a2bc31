#include "render/trace/step.h"

#include "render/film/film.h"
#include "render/scene/scene_builder.h"
#include "render/shape/primitives.h"
#include "render/trace/primary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace firstlight::render {
namespace {

Finish dark() {
  Finish finish;
  finish.ambient = Rgb(0.0f);
  finish.diffuse = 0.0;
  return finish;
}

TexturePtr texture_of(const FilteredColor& color, const Finish& finish) {
  Texture texture;
  texture.layers.push_back({});
  texture.layers[0].pigment.color = color;
  texture.layers[0].finish = finish;
  return std::make_shared<const Texture>(texture);
}

Object object_of(ShapePtr shape, TexturePtr texture) {
  Object object;
  object.kind = Object::Kind::shape;
  object.shape = std::move(shape);
  object.texture = std::move(texture);
  return object;
}

Object point_light(const Vec3& position) {
  Object object;
  object.kind = Object::Kind::light;
  object.extras.change().light.change().position = position;
  return object;
}

/// A scene, ready to be traced task by task.
class TestScene {
 public:
  explicit TestScene(std::vector<Object> objects, const std::function<void(Settings&)>& change = {}) {
    SceneBuilder builder;
    builder.set_camera(Camera{});
    if (change) change(builder.settings());
    const TexturePtr grey_default = texture_of({Rgb(0.0f), 0.0f, 0.0f}, dark());
    for (Object& object : objects) builder.add(object, grey_default);
    scene_ = builder.build();
    accel_ = std::make_unique<Accel>(*scene_);
  }

  const Scene& scene() const { return *scene_; }
  TraceContext context() { return {*scene_, *accel_, media_}; }

  static RayTask task(const Vec3& origin, const Vec3& direction) {
    RayTask task;
    task.origin = origin;
    task.set_direction(PackedDirection(direction.normalized()));
    task.set_weight(Rgb(1.0f), 1.0f);
    return task;
  }

  /// The colour that the ray brings, its whole tree traced one task at a time.
  Rgb color(const Vec3& origin, const Vec3& direction) {
    Stepper stepper(context());
    Film film(1, 1);
    std::vector<RayTask> waiting{task(origin, direction)};
    while (!waiting.empty()) {
      const RayTask next = waiting.back();
      waiting.pop_back();
      stepper.step({&next, 1});
      film.add(stepper.light());
      waiting.insert(waiting.end(), stepper.spawned().begin(), stepper.spawned().end());
    }
    counts = stepper.counts();
    return film.color(0, 0);
  }

  RayCounts counts;

 private:
  std::unique_ptr<const Scene> scene_;
  std::unique_ptr<Accel> accel_;
  MediumTable media_;
};

void expect_color(const Rgb& found, const Rgb& expected) {
  EXPECT_NEAR(found.x, expected.x, 1e-5);
  EXPECT_NEAR(found.y, expected.y, 1e-5);
  EXPECT_NEAR(found.z, expected.z, 1e-5);
}

FilteredColor opaque(float value) { return {Rgb(value), 0.0f, 0.0f}; }

TEST(Step, AClosedRoomOfMirrorsIsAGeometricSeries) {
  Finish finish = dark();
  finish.emission = Rgb(0.5f);
  finish.reflection_min = finish.reflection_max = Rgb(0.5f);
  TestScene room({object_of(make_box({-1, -1, -1}, {1, 1, 1}), texture_of(opaque(1.0f), finish))});
  // Five levels: 0.5 (1 + 1/2 + 1/4 + 1/8 + 1/16).
  expect_color(room.color({0.1, 0.2, 0.3}, {1, 0.3, 0.2}), Rgb(0.96875f));
  EXPECT_EQ(room.counts.of(RayKind::primary), 1u);
  EXPECT_EQ(room.counts.of(RayKind::reflection), 4u);
}

TEST(Step, WeightBelowBailoutIsNotTraced) {
  Finish finish = dark();
  finish.emission = Rgb(0.5f);
  finish.reflection_min = finish.reflection_max = Rgb(0.5f);
  TestScene room({object_of(make_box({-1, -1, -1}, {1, 1, 1}), texture_of(opaque(1.0f), finish))},
                 [](Settings& settings) { settings.adc_bailout = 0.3; });
  expect_color(room.color({0.1, 0.2, 0.3}, {1, 0.3, 0.2}), Rgb(0.75f));
}

TEST(Step, DiffuseLightFollowsLambert) {
  Finish finish = dark();
  finish.diffuse = 0.8;
  TestScene scene({object_of(make_plane({0, 1, 0}, 0.0), texture_of(opaque(0.5f), finish)), point_light({3, 4, 0})});
  // cos = 4/5 at the origin: 0.5 * 0.8 * 0.8.
  expect_color(scene.color({0, 1, 0}, {0, -1, 0}), Rgb(0.32f));
  EXPECT_EQ(scene.counts.of(RayKind::shadow), 1u);
}

TEST(Step, ABlockedLightIsTakenBackToTheLastBit) {
  Finish finish = dark();
  finish.diffuse = 0.7;
  finish.specular = 0.3;
  TestScene scene({object_of(make_plane({0, 1, 0}, 0.0), texture_of(opaque(0.3f), finish)),
                   object_of(make_sphere({3, 4, 0}, 0.5), texture_of(opaque(1.0f), dark())), point_light({6, 8, 0})});
  EXPECT_EQ(scene.color({0, 1, 0}, {0, -1, 0}), Rgb(0.0f));
}

TEST(Step, AFilterTintsTheShadow) {
  Finish finish = dark();
  finish.diffuse = 1.0;
  const FilteredColor red_glass{Rgb(1.0f, 0.5f, 0.0f), 0.5f, 0.25f};
  TestScene scene({object_of(make_plane({0, 1, 0}, 0.0), texture_of(opaque(1.0f), finish)),
                   object_of(make_disc({0, 2, 0}, {0, 1, 0}, 0.5, 0.0), texture_of(red_glass, dark())),
                   point_light({0, 4, 0})});
  expect_color(scene.color({2, 2, 0}, {-2, -2, 0}), Rgb(0.75f, 0.5f, 0.25f));
}

TEST(Step, AShadowlessLightShinesThroughAndGivesNoHighlight) {
  Finish finish = dark();
  finish.diffuse = 1.0;
  finish.specular = 1.0;
  Object light = point_light({0, 4, 0});
  light.extras.change().light.change().shadowless = true;
  TestScene scene({object_of(make_plane({0, 1, 0}, 0.0), texture_of(opaque(0.5f), finish)),
                   object_of(make_sphere({0, 2, 0}, 0.5), texture_of(opaque(1.0f), dark())), light});
  expect_color(scene.color({1, 1, 0}, {-1, -1, 0}), Rgb(0.5f));
  EXPECT_EQ(scene.counts.of(RayKind::shadow), 0u);
}

TEST(Step, GoingStraightOnDoesNotRaiseTheLevel) {
  Finish glow = dark();
  glow.emission = Rgb(1.0f);
  std::vector<Object> objects;
  for (int i = 1; i <= 10; ++i) {
    objects.push_back(object_of(make_plane({0, 0, -1}, -i), texture_of({Rgb(1.0f), 0.0f, 1.0f}, dark())));
  }
  objects.push_back(object_of(make_plane({0, 0, -1}, -20), texture_of(opaque(0.5f), glow)));
  TestScene scene(std::move(objects), [](Settings& settings) { settings.max_trace_level = 3; });
  expect_color(scene.color({0, 0, 0}, {0.1, 0.2, 1}), Rgb(0.5f));
}

TEST(Step, ARefractedRayObeysSnell) {
  Object glass = object_of(make_plane({0, 1, 0}, 0.0), texture_of({Rgb(1.0f), 1.0f, 0.0f}, dark()));
  glass.extras.change().interior = Interior{.ior = 1.5};
  TestScene scene({glass});
  Stepper stepper(scene.context());
  const RayTask task = TestScene::task({-1, 1, 0}, {1, -1, 0});
  stepper.step({&task, 1});
  ASSERT_EQ(stepper.spawned().size(), 1u);
  const RayTask& inside = stepper.spawned()[0];
  EXPECT_EQ(inside.kind, RayKind::transmission);
  EXPECT_NEAR(inside.direction().unpack().x, std::sqrt(0.5) / 1.5, 1e-8);
  EXPECT_NE(inside.medium, MediumTable::kOutside);
}

TEST(Step, GrazingLightInsideGlassIsTotallyReflected) {
  Object glass = object_of(make_plane({0, 1, 0}, 0.0), texture_of({Rgb(1.0f), 1.0f, 0.0f}, dark()));
  glass.extras.change().interior = Interior{.ior = 1.5};
  TestScene scene({glass});
  TraceContext context = scene.context();
  Stepper stepper(context);
  RayTask task = TestScene::task({-1, -1, 0}, {1, 1, 0});
  task.medium = context.media.entered(MediumTable::kOutside, scene.scene().parts[0].interior);
  stepper.step({&task, 1});
  ASSERT_EQ(stepper.spawned().size(), 1u);
  EXPECT_EQ(stepper.spawned()[0].kind, RayKind::reflection);
  EXPECT_NEAR(stepper.spawned()[0].direction().unpack().y, -std::sqrt(0.5), 1e-8);
  EXPECT_EQ(stepper.spawned()[0].medium, task.medium);
}

TEST(Step, FresnelReflectionLooksStraightDownAtTheIndexRatio) {
  Finish finish = dark();
  finish.reflection_fresnel = true;
  finish.reflection_max = Rgb(1.0f);
  Object glass = object_of(make_plane({0, 1, 0}, 0.0), texture_of(opaque(0.0f), finish));
  glass.extras.change().interior = Interior{.ior = 1.5};
  TestScene scene({glass}, [](Settings& settings) { settings.background = Rgb(1.0f); });
  expect_color(scene.color({0, 1, 0}, {0, -1, 0}), Rgb(0.04f));  // ((1.5 - 1) / (1.5 + 1))^2
}

TEST(Step, AReflectionExponentWorksOnTheReturnedColour) {
  Finish mirror = dark();
  mirror.reflection_min = mirror.reflection_max = Rgb(0.5f);
  mirror.reflection_exponent = 2.0;
  TestScene scene({object_of(make_plane({0, 1, 0}, 0.0), texture_of(opaque(0.0f), mirror))},
                  [](Settings& settings) { settings.background = Rgb(0.5f, 0.25f, 1.0f); });
  expect_color(scene.color({0, 1, 0}, {0.5, -1, 0}), Rgb(0.125f, 0.03125f, 0.5f));
}

TEST(Step, ACameraInsideGlassIsInsideOfItsMatter) {
  Object glass = object_of(make_sphere({0, 0, 0}, 2.0), texture_of({Rgb(1.0f), 1.0f, 0.0f}, dark()));
  glass.extras.change().interior = Interior{.ior = 1.5};
  TestScene scene({glass, object_of(make_sphere({9, 0, 0}, 2.0), texture_of(opaque(1.0f), dark()))});
  MediumTable& media = scene.context().media;
  const std::uint32_t medium = medium_at(scene.scene(), media, {0.5, 0, 0});
  EXPECT_EQ(media.depth(medium), 1u);
  EXPECT_EQ(scene.scene().interiors[media.innermost(medium)]->ior, 1.5);
  EXPECT_EQ(medium_at(scene.scene(), media, {5, 0, 0}), MediumTable::kOutside);
}

TEST(Step, BatchesDoNotShowInThePicture) {
  Finish mirror;
  mirror.reflection_min = mirror.reflection_max = Rgb(0.3f);
  std::vector<Object> objects{object_of(make_plane({0, 1, 0}, -1.0), texture_of(opaque(0.7f), mirror)),
                              point_light({5, 9, -4}), point_light({-6, 3, -2})};
  for (int i = -2; i <= 2; ++i) {
    objects.push_back(object_of(make_sphere({1.1 * i, 0, 5}, 0.6),
                                texture_of({Rgb(0.9f, 0.5f, 0.4f), 0.2f * (i & 1), 0.0f}, mirror)));
  }
  TestScene scene(std::move(objects));
  const auto render = [&](std::size_t batch) {
    Stepper stepper(scene.context());
    Film film(24, 16);
    const PrimaryRays rays(scene.scene(), scene.context().media, {scene.scene().camera, 24, 16});
    PrimaryBatch primaries;
    for (std::uint32_t pixel = 0; pixel < 24 * 16; ++pixel) {
      const PrimaryPlace place{pixel % 24 + 0.5, pixel / 24 + 0.5, pixel};
      rays.append({&place, 1}, primaries);
    }
    std::vector<RayTask> waiting = primaries.tasks;
    while (!waiting.empty()) {
      const std::size_t count = std::min(batch, waiting.size());
      const std::vector<RayTask> tasks(waiting.end() - static_cast<std::ptrdiff_t>(count), waiting.end());
      waiting.resize(waiting.size() - count);
      stepper.step(tasks);
      film.add(stepper.light());
      waiting.insert(waiting.end(), stepper.spawned().begin(), stepper.spawned().end());
    }
    return film.snapshot();
  };
  const std::vector<Rgb> one_by_one = render(1);
  EXPECT_EQ(render(7), one_by_one);
  EXPECT_EQ(render(1000), one_by_one);
  EXPECT_TRUE(std::any_of(one_by_one.begin(), one_by_one.end(), [](const Rgb& c) { return c.x > 0.1f; }));
}

}  // namespace
}  // namespace firstlight::render
