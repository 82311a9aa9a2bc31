#include "render/trace/radiance_bound.h"

#include "render/scene/scene_builder.h"
#include "render/shape/primitives.h"
#include "render/texture/patterning.h"
#include "tests/render/random_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

// ---- Bounds that are known on paper ---------------------------------------------------------------------------------

constexpr double kMargin = 2e-4;  // the bound is a little more than computed

Finish dark() {
  Finish finish;
  finish.ambient = Rgb(0.0f);
  finish.diffuse = 0.0;
  return finish;
}

Finish mirror(float reflection) {
  Finish finish = dark();
  finish.reflection_min = finish.reflection_max = Rgb(reflection);
  return finish;
}

Finish shining() {
  Finish finish = dark();
  finish.specular = 0.5;
  return finish;
}

Object floor_of(std::vector<TextureLayer> layers) {
  Object object;
  object.shape = make_plane({0, 1, 0}, 0.0);
  object.texture = std::make_shared<const Texture>(Texture{std::move(layers)});
  return object;
}

Object floor_of(const FilteredColor& color, const Finish& finish) {
  TextureLayer layer;
  layer.pigment.color = color;
  layer.finish = finish;
  return floor_of({layer});
}

Object light_of(const Rgb& color) {
  Object object;
  object.kind = Object::Kind::light;
  object.extras.change().light.change().color = color;
  object.extras.change().light.change().position = Vec3(0, 5, 0);
  return object;
}

std::unique_ptr<const Scene> scene_of(std::vector<Object> objects, const std::function<void(Settings&)>& change = {}) {
  SceneBuilder builder;
  Camera camera;
  camera.location = Vec3(0, 1, 0);
  builder.set_camera(camera);
  if (change) change(builder.settings());
  const TexturePtr plain = std::make_shared<const Texture>(Texture{std::vector<TextureLayer>(1)});
  for (Object& object : objects) builder.add(object, plain);
  return builder.build();
}

void white_sky(Settings& settings) { settings.background = Rgb(1.0f); }

const FilteredColor kWhite{Rgb(1.0f), 0.0f, 0.0f};
const FilteredColor kClear{Rgb(1.0f), 0.0f, 1.0f};

TEST(RadianceBound, OfMirrorsIsAGeometricSeries) {
  Finish finish = mirror(0.5f);
  finish.emission = Rgb(0.5f);
  const auto scene = scene_of({floor_of(kWhite, finish)});
  const RadianceBound bound(*scene);
  EXPECT_TRUE(bound.known());
  EXPECT_NEAR(bound.most(0), 0.96875, kMargin);  // 0.5 (1 + 1/2 + 1/4 + 1/8 + 1/16)
  EXPECT_NEAR(bound.most(4), 0.5, kMargin);
  EXPECT_GE(bound.most(4), 0.5f);
}

TEST(RadianceBound, AddsLightsChannelByChannelAtTheirBrightest) {
  Finish finish = dark();
  finish.diffuse = 0.5;
  const auto most = [&](std::vector<Object> lights) {
    lights.push_back(floor_of(kWhite, finish));
    return RadianceBound(*scene_of(std::move(lights))).most(0);
  };
  EXPECT_NEAR(most({light_of({1, 0, 0}), light_of({0, 0, 1})}), 0.5, kMargin);
  EXPECT_NEAR(most({light_of({1, 0, 0}), light_of({-1, 0, 1})}), 1.0, kMargin);
  Object fading = light_of(Rgb(1.0f));
  fading.extras.change().light.change().fade_power = 2.0;
  fading.extras.change().light.change().fade_distance = 3.0;
  EXPECT_NEAR(most({fading}), 1.0, kMargin);  // close by twice the full light
  finish.specular = 0.25;
  EXPECT_NEAR(most({light_of(Rgb(1.0f))}), 0.75, kMargin);
  Object shadowless = light_of(Rgb(1.0f));
  shadowless.extras.change().light.change().shadowless = true;
  EXPECT_NEAR(most({shadowless}), 0.5, kMargin);  // no highlight
}

TEST(RadianceBound, LayersDoNotDimTheMirrorsBelow) {
  TextureLayer varnish;
  varnish.pigment.color = {Rgb(1.0f), 0.5f, 0.0f};
  varnish.finish = dark();
  varnish.finish.change().emission = Rgb(0.5f);
  TextureLayer metal;
  metal.finish = mirror(1.0f);
  const auto scene = scene_of({floor_of({varnish, metal})}, white_sky);
  EXPECT_NEAR(RadianceBound(*scene).most(3), 1.25, kMargin);
}

TEST(RadianceBound, BetweenColoursOfAMapMoreMayPassThanThroughEither) {
  TextureLayer layer;
  const ColorMap map = {{0.0, {Rgb(1.0f), 0.0f, 0.0f}}, {1.0, {Rgb(0.0f), 1.0f, 0.0f}}};
  layer.pigment.pattern = PigmentPattern{patterned(PatternKind::gradient, GradientParameters{{1, 0, 0}}), map};
  layer.finish = mirror(0.9f);
  // A quarter passes in the middle: 0.9 / (1 - 1/4), for rows of such surfaces.
  EXPECT_NEAR(RadianceBound(*scene_of({floor_of({layer})}, white_sky)).most(3), 1.2, kMargin);
  layer.pigment.pattern = PigmentPattern{patterned(PatternKind::checker), map};
  EXPECT_NEAR(RadianceBound(*scene_of({floor_of({layer})}, white_sky)).most(3), 1.0, kMargin);
}

TEST(RadianceBound, ConservedEnergyIsMirroredOrPassed) {
  Finish finish = mirror(0.7f);
  finish.conserve_energy = true;
  const RadianceBound bound(*scene_of({floor_of(kClear, finish)}, white_sky));
  EXPECT_TRUE(bound.known());
  EXPECT_NEAR(bound.most(0), 1.0, kMargin);
}

TEST(RadianceBound, OldSurfacesKeepMoreOfTheirOwnLight) {
  Finish glowing = dark();
  glowing.emission = Rgb(1.0f);
  const auto most = [&](int version) {
    // The red that is filtered away counts as the surface's own before 3.7.
    const FilteredColor color{Rgb(0.5f, 0.25f, 0.25f), 1.0f, 0.0f};
    return RadianceBound(*scene_of({floor_of(color, glowing)},
                                   [version](Settings& settings) {
                                     settings.language_version = version;
                                     settings.max_trace_level = 1;
                                   }))
        .most(0);
  };
  EXPECT_NEAR(most(370), 0.0, kMargin);
  EXPECT_GE(most(350), 0.25f);
}

TEST(RadianceBound, IsKnownWhereRowsAreShort) {
  const auto known = [](std::vector<Object> objects) {
    objects.push_back(light_of(Rgb(1.0f)));
    return RadianceBound(*scene_of(std::move(objects))).known();
  };
  EXPECT_TRUE(known({floor_of(kClear, dark())}));  // adds no light, however many there are
  EXPECT_TRUE(known({floor_of({Rgb(1.0f), 0.0f, 0.9f}, shining())}));
  EXPECT_FALSE(known({floor_of(kClear, shining())}));
  Object glass = floor_of(kClear, shining());
  glass.extras.change().interior = Interior{.ior = 1.5};
  EXPECT_TRUE(known({glass}));  // bends every ray, which raises the level
  Object other_glass = glass;
  other_glass.placement = Transform::translation({0, -1, 0});
  EXPECT_FALSE(known({glass, other_glass}));  // from one into the other rays go straight on
}

TEST(RadianceBound, IsNotKnownWhereATermHasNoLargestValue) {
  const auto known = [](const FilteredColor& color, const Finish& finish) {
    return RadianceBound(*scene_of({floor_of(color, finish), light_of(Rgb(1.0f))})).known();
  };
  EXPECT_TRUE(known(kWhite, Finish()));
  Finish finish;
  finish.brilliance = -1.0;
  EXPECT_FALSE(known(kWhite, finish));
  finish = mirror(0.5f);
  finish.reflection_falloff = -1.0;
  EXPECT_FALSE(known(kWhite, finish));
  finish = mirror(0.5f);
  finish.reflection_exponent = -1.0;
  EXPECT_FALSE(known(kWhite, finish));
  EXPECT_FALSE(known({Rgb(2.0f), 0.9f, 0.0f}, dark()));  // filters that make light brighter
}

TEST(RadianceBound, FeelersHaveTheLightTheyCarryAtStake) {
  RayTask feelers;
  feelers.set_feeler(0, PackedRgb(Rgb(0.5f, 0.25f, 0.0f)));
  feelers.add_feeler(1, PackedRgb(Rgb(-0.25f, 0.125f, 0.5f)));
  const RadianceBound bound(*scene_of({floor_of(kWhite, dark())}));
  EXPECT_NEAR(FixedRgb::to_double(bound.at_stake(feelers)), 0.75, 1e-9);
}

// ---- Whole trees of random scenes -----------------------------------------------------------------------------------

#ifdef FIRSTLIGHT_SANITIZED
constexpr std::uint32_t kOneIn = 3;  // of the random scenes; everything takes many times as long
#else
constexpr std::uint32_t kOneIn = 1;
#endif
constexpr std::uint32_t kColumns = 8;
constexpr std::uint32_t kRows = 6;

std::vector<RayTask> primaries_of(RandomScene& scene) {
  std::vector<RayTask> tasks;
  for (std::uint32_t i = 0; i < kColumns * kRows; ++i) {
    tasks.push_back(scene.primary((i % kColumns + 0.5) / kColumns, (i / kColumns + 0.5) / kRows, i));
  }
  return tasks;
}

/// The light that a ray and all that come of it bring. Calls visit(task, light) for each of them.
template <class Visit>
FixedRgb light_of_tree(Stepper& stepper, const RayTask& task, const Visit& visit) {
  stepper.step({&task, 1});
  FixedRgb sum = stepper.light()[0].light;
  const std::vector<RayTask> children(stepper.spawned().begin(), stepper.spawned().end());
  for (const RayTask& child : children) sum += light_of_tree(stepper, child, visit);
  visit(task, sum);
  return sum;
}

TEST(RadianceBound, NoRayBringsMoreThanIsAtStake) {
  int known_scenes = 0;
  std::uint64_t rays = 0;
  for (const auto fancy : {Fancy::plausible, Fancy::clear_rows, Fancy::wild}) {
    for (std::uint32_t seed = 1; seed <= 750 / kOneIn; ++seed) {
      RandomScene scene(seed, fancy);
      const RadianceBound bound(scene.scene());
      if (!bound.known()) continue;
      known_scenes++;
      Stepper stepper(scene.context());
      for (const RayTask& primary : primaries_of(scene)) {
        light_of_tree(stepper, primary, [&](const RayTask& task, const FixedRgb& light) {
          rays++;
          ASSERT_LE(light.max_magnitude(), bound.at_stake(task))
              << "scene " << seed << " of kind " << static_cast<int>(fancy) << ", ray of kind "
              << static_cast<int>(task.kind) << " at level " << static_cast<int>(task.level);
        });
        ASSERT_FALSE(HasFailure());
      }
    }
  }
  EXPECT_GT(known_scenes, 800 / static_cast<int>(kOneIn));
  EXPECT_GT(rays, 90000u / kOneIn);
}

// ---- Pictures in progress -------------------------------------------------------------------------------------------

/// Sums that are as exact as the film's, and can be compared to the last bit.
struct Sums {
  std::vector<FixedRgb> light = std::vector<FixedRgb>(kColumns * kRows);
  std::vector<std::int64_t> outstanding = std::vector<std::int64_t>(kColumns * kRows);
};

/// Traces the picture in random order and in random batches. Calls visit(sums, light) after each batch.
template <class Visit>
Sums trace_in_random_order(RandomScene& scene, std::uint32_t seed, const Visit& visit) {
  std::mt19937 random(seed);
  const RadianceBound bound(scene.scene());
  Stepper stepper(scene.context());
  Sums sums;
  std::vector<RayTask> bag = primaries_of(scene);
  for (const RayTask& task : bag) sums.outstanding[task.sample] += bound.at_stake(task);
  std::vector<RayTask> batch;
  while (!bag.empty()) {
    batch.clear();
    for (std::size_t count = 1 + random() % 5; count > 0 && !bag.empty(); --count) {
      std::swap(bag[random() % bag.size()], bag.back());
      batch.push_back(bag.back());
      bag.pop_back();
    }
    stepper.step(batch);
    for (const Contribution& contribution : stepper.light()) {
      sums.light[contribution.sample] += contribution.light;
      sums.outstanding[contribution.sample] += contribution.outstanding;
    }
    bag.insert(bag.end(), stepper.spawned().begin(), stepper.spawned().end());
    visit(sums, stepper.light());
  }
  return sums;
}

// In wild scenes weights grow until they are no numbers any more; batches must not spread that from hit to hit.
TEST(RandomOrder, EndsInTheSameBitsInWildScenes) {
  const auto nobody = [](const Sums&, std::span<const Contribution>) {};
  for (std::uint32_t seed = 1; seed <= 2000 / kOneIn; ++seed) {
    RandomScene scene(seed, Fancy::wild);
    const Sums final = trace_in_random_order(scene, seed, nobody);
    EXPECT_TRUE(trace_in_random_order(scene, seed + 1000000, nobody).light == final.light) << seed;
  }
}

/// How often the true difference from the final picture was within what is outstanding.
struct Held {
  int scenes = 0;
  std::uint64_t moments = 0;  ///< of one sample
  std::uint64_t within = 0;
  std::uint64_t pictures = 0;  ///< moments of a whole picture
  std::uint64_t means_within = 0;
};

/// Pre: `sums` and `final` are of the same picture. The sums of absurd scenes need more than 64 bits.
std::pair<long double, long double> totals(const Sums& sums, const Sums& final) {
  long double difference = 0;
  long double outstanding = 0;
  for (std::size_t i = 0; i < sums.light.size(); ++i) {
    FixedRgb missing = final.light[i];
    missing -= sums.light[i];
    difference += static_cast<long double>(missing.max_magnitude());
    outstanding += static_cast<long double>(sums.outstanding[i]);
  }
  return {difference, outstanding};
}

Held look_at_all_moments(Fancy fancy, std::uint32_t scenes, bool known) {
  Held held;
  for (std::uint32_t seed = 1; seed <= scenes; ++seed) {
    RandomScene scene(seed, fancy);
    if (RadianceBound(scene.scene()).known() != known) continue;
    held.scenes++;
    const auto nobody = [](const Sums&, std::span<const Contribution>) {};
    const Sums final = trace_in_random_order(scene, seed, nobody);
    EXPECT_TRUE(std::ranges::all_of(final.outstanding, [](std::int64_t left) { return left == 0; })) << seed;
    const Sums again =
        trace_in_random_order(scene, seed + 1000000, [&](const Sums& sums, std::span<const Contribution> changed) {
          for (const Contribution& contribution : changed) {
            FixedRgb missing = final.light[contribution.sample];
            missing -= sums.light[contribution.sample];
            held.moments++;
            held.within += missing.max_magnitude() <= sums.outstanding[contribution.sample] ? 1 : 0;
          }
          const auto [difference, outstanding] = totals(sums, final);
          held.pictures++;
          held.means_within += difference <= outstanding ? 1 : 0;
        });
    EXPECT_EQ(again.light, final.light) << seed;
  }
  return held;
}

TEST(RadianceBound, WhatIsOutstandingBoundsTheDifferenceAtAnyMoment) {
  for (const auto fancy : {Fancy::plausible, Fancy::clear_rows, Fancy::wild}) {
    const Held held = look_at_all_moments(fancy, 300 / kOneIn, true);
    EXPECT_GT(held.scenes, 40 / static_cast<int>(kOneIn)) << static_cast<int>(fancy);
    EXPECT_GT(held.moments, 3000u / kOneIn) << static_cast<int>(fancy);
    EXPECT_EQ(held.within, held.moments) << static_cast<int>(fancy);
    EXPECT_EQ(held.means_within, held.pictures) << static_cast<int>(fancy);
  }
}

/// Discs of clear glass in a row, each with a highlight where it is looked at.
double highlights_in_a_row(int count) {
  Finish finish = dark();
  finish.specular = 1.0;
  finish.roughness_exponent = 1.0;
  std::vector<Object> objects{light_of(Rgb(0.1f))};
  for (int i = 0; i < count; ++i) {
    objects.push_back(floor_of(kClear, finish));
    objects.back().placement = Transform::translation({0, -0.5 * i, 0});
    objects.back().no_shadow = true;
  }
  const auto scene = scene_of(std::move(objects));
  const Accel accel(*scene);
  MediumTable media;
  Stepper stepper({*scene, accel, media});
  RayTask task;
  task.origin = Vec3(0, 1, 0);
  task.set_direction(PackedDirection(Vec3(0, -1, 0)));
  task.set_weight(Rgb(1.0f), 1.0f);
  const RadianceBound bound(*scene);
  EXPECT_FALSE(bound.known());
  const FixedRgb light = light_of_tree(stepper, task, [](const RayTask&, const FixedRgb&) {});
  return static_cast<double>(light.max_magnitude()) / static_cast<double>(bound.at_stake(task));
}

TEST(RadianceBound, AnEstimateAllowsForFourSurfacesInARow) {
  EXPECT_LE(highlights_in_a_row(4), 1.0);
  EXPECT_GT(highlights_in_a_row(5), 1.0);
}

// Measures what the header says of estimates.
TEST(RadianceBound, EstimatesHoldInRandomScenes) {
  for (const auto fancy : {Fancy::plausible, Fancy::clear_rows}) {
    const Held held = look_at_all_moments(fancy, 600 / kOneIn, false);
    EXPECT_GT(held.scenes, 100 / static_cast<int>(kOneIn));
    EXPECT_GT(held.moments, 10000u / kOneIn);
    EXPECT_EQ(held.within, held.moments);
    EXPECT_EQ(held.means_within, held.pictures);
  }
  const Held wild = look_at_all_moments(Fancy::wild, 600 / kOneIn, false);
  EXPECT_GT(wild.scenes, 100 / static_cast<int>(kOneIn));
  EXPECT_GE(static_cast<double>(wild.within), 0.998 * static_cast<double>(wild.moments));
  EXPECT_GE(static_cast<double>(wild.means_within), 0.995 * static_cast<double>(wild.pictures));
}

}  // namespace
}  // namespace firstlight::render
