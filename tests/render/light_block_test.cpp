#include "render/light/area_grid.h"
#include "render/math/fixed_rgb.h"
#include "render/scene/scene_builder.h"
#include "render/trace/hit_block.h"
#include "render/trace/local_light.h"
#include "render/trace/radiance_bound.h"
#include "tests/render/dice.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace firstlight::render {
namespace {

/// A hit with one layer, and the light that it gets of one light, by the formulas of POV-Ray's manual.
struct LitHit {
  Vec3 point;
  Vec3 direction;
  Vec3 normal;
  Rgb color;
  Rgb share;
  double diffuse = 0.0;
  double diffuse_back = 0.0;
  double brilliance = 1.0;
  double phong = 0.0;
  double phong_size = 40.0;
  double specular = 0.0;
  double specular_exponent = 20.0;
  double metallic = 0.0;

  void put(HitBlock& block, std::size_t i) const {
    block.point.set(i, point);
    block.direction.set(i, direction);
    block.normal.set(i, normal);
    block.lit_from[i] = 1e-10;
    block.own_light.set(i, Vec3(0.0));
    block.lit_from_behind = true;
    LayerColumns& layer = block.layers[0];
    layer.color.set(i, color);
    layer.share.set(i, share);
    layer.diffuse[i] = diffuse;
    layer.has_rare = true;
    layer.diffuse_back[i] = diffuse_back;
    layer.brilliance[i] = brilliance;
    layer.phong[i] = phong;
    layer.phong_size[i] = phong_size;
    layer.specular[i] = specular;
    layer.specular_exponent[i] = specular_exponent;
    layer.metallic[i] = metallic;
  }

  Rgb lit_by(const Light& light) const {
    if (!has_spread_light(light)) return lit_from(light, light.position);
    const AreaGrid grid(light, point, AreaGrid::Use::illumination);
    const auto points = static_cast<float>(light.area->size1 * light.area->size2);
    Rgb sum(0.0f);
    for (int u = 0; u < light.area->size1; ++u) {
      for (int v = 0; v < light.area->size2; ++v) sum += lit_from(light, grid.place(u, v)) * (1.0f / points);
    }
    return sum;
  }

  /// The share of a light at `place` that the beam and the distance leave, by the manual.
  double arriving(const Light& light, const Vec3& place) const {
    const Vec3 axis = (light.point_at - light.position).normalized();
    const Vec3 along = light.parallel ? (light.point_at - place).normalized() : (point - place).normalized();
    const double depth = (point - place).dot(along);
    const auto soft = [](double low, double high, double x) {
      const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
      return t * t * (3.0 - 2.0 * t);
    };
    double share = 1.0;
    if (light.kind == LightKind::spotlight) {
      const double degree = std::acos(-1.0) / 180.0;
      const double cosine = depth > 0.0 ? along.dot(axis) : -along.dot(axis);
      if (cosine <= 0.0) return 0.0;
      share = std::pow(cosine, light.tightness) *
              soft(std::cos(light.falloff * degree), std::cos(light.radius * degree), cosine);
    } else if (light.kind == LightKind::cylinder) {
      const Vec3 way = point - light.position;
      const double distance = (way - axis * way.dot(axis)).length();
      if (way.dot(axis) <= 0.0 || distance >= light.falloff) return 0.0;
      const double left = 1.0 - distance / light.falloff;
      share = std::pow(left, light.tightness) * soft(0.0, 1.0 - light.radius / light.falloff, left);
    }
    return share > 0.0 ? share * fading(light, depth) : 0.0;
  }

  Rgb lit_from(const Light& light, const Vec3& place) const {
    const Vec3 to_light = light.parallel ? (place - light.point_at).normalized() : (place - point).normalized();
    const double cosine = normal.dot(to_light);
    const bool behind = cosine < 1e-10;
    Rgb term = color * static_cast<float>((behind ? diffuse_back : diffuse) * std::pow(std::abs(cosine), brilliance));
    if (!behind && !light.shadowless) {
      const Vec3 mirrored = direction - normal * (2.0 * direction.dot(normal));
      const Vec3 halfway = (to_light - direction).normalized();
      const double shine = std::pow(std::max(mirrored.dot(to_light), 0.0), phong_size) * phong;
      const double gloss = std::pow(std::max(halfway.dot(normal), 0.0), specular_exponent) * specular;
      term += metallic_tint(Rgb(1.0f), color, metallic, cosine) * static_cast<float>(shine + gloss);
    }
    return share * term * light.color * static_cast<float>(arriving(light, place));
  }
};

LitHit random_hit(Dice& dice) {
  LitHit hit;
  hit.point = dice.point(3.0);
  hit.direction = dice.direction();
  hit.normal = dice.direction();
  if (hit.normal.dot(hit.direction) > 0.0) hit.normal = -hit.normal;
  hit.color = dice.color();
  hit.share = dice.color();
  hit.diffuse = dice.between(0.0, 1.0);
  if (dice.below(3) == 0) hit.diffuse_back = dice.between(0.0, 1.0);
  if (dice.below(3) == 0) hit.brilliance = dice.between(0.1, 8.0);
  if (dice.below(2) == 0) hit.phong = dice.between(0.0, 1.0);
  hit.phong_size = dice.between(1.0, 55.0);
  if (dice.below(2) == 0) hit.specular = dice.between(0.0, 1.0);
  hit.specular_exponent = std::pow(10.0, dice.between(0.0, 3.5));
  if (dice.below(2) == 0) hit.metallic = dice.between(0.0, 1.0);
  return hit;
}

Light random_light(Dice& dice) {
  Light light;
  light.position = dice.point(9.0);
  light.color = dice.color();
  if (dice.below(2) == 0) {
    light.fade_distance = dice.between(-1.0, 9.0);
    light.fade_power = dice.below(4) == 0 ? 2.0 : std::round(dice.between(1.0, 4.0));
  }
  light.shadowless = dice.below(4) == 0;
  light.kind = static_cast<LightKind>(dice.below(4) == 0 ? 0 : dice.below(3));
  light.point_at = dice.point(3.0);
  light.parallel = light.kind == LightKind::cylinder || dice.below(3) == 0;
  if (light.parallel) light.fade_power = dice.below(2) == 0 ? 0.0 : 2.0;  // of negative distances, too
  light.radius = light.kind == LightKind::spotlight ? dice.between(1.0, 40.0) : dice.between(0.1, 3.0);
  light.falloff = light.radius + dice.between(0.1, 4.0) * (light.kind == LightKind::spotlight ? 10.0 : 1.0);
  if (dice.below(2) == 0) light.tightness = dice.between(0.0, 20.0);
  if (dice.below(4) == 0) {
    light.area = AreaLight{dice.point(3.0), dice.point(3.0), 1 + static_cast<int>(dice.below(4)), 3};
    light.area_illumination = dice.below(2) == 0;
    light.jitter = dice.below(2) == 0;
  }
  return light;
}

std::unique_ptr<HitBlock> block_of(const std::vector<LitHit>& hits) {
  auto block = std::make_unique<HitBlock>();
  block->begin(hits.size());
  block->layers.resize(1);
  block->layer_count = 1;
  for (const LitHit& hit : hits) hit.put(*block, block->size++);
  begin_light(*block);
  return block;
}

/// The light that the feeler of a hit to a light holds; black where none is to be traced.
PackedRgb held(const HitBlock& block, std::size_t light, std::size_t hit) {
  return (block.open[light] >> hit & 1u) != 0 ? PackedRgb::from_bits(block.light[light][hit]) : PackedRgb();
}

FixedRgb sum_of(const HitBlock& block, std::size_t hit) {
  return {block.sum.of[0][hit], block.sum.of[1][hit], block.sum.of[2][hit]};
}

/// The results of a block, as bytes.
std::vector<std::int64_t> found(const HitBlock& block, std::size_t lights) {
  std::vector<std::int64_t> all;
  for (std::size_t i = 0; i < block.size; ++i) {
    all.push_back(block.mirrored[i]);
    for (const auto& column : block.sum.of) all.push_back(column[i]);
    all.push_back(block.at_stake[i]);
    for (std::size_t l = 0; l < lights; ++l) all.push_back(std::bit_cast<std::int64_t>(held(block, l, i)));
  }
  return all;
}

void for_each_instruction_set(const std::function<void()>& test) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::GetChosenTarget().Update(target);
    test();
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(LightBlock, LightIsThatOfTheFormulas) {
  Dice dice(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<LitHit> hits;
    for (std::size_t i = 0; i < 29; ++i) hits.push_back(random_hit(dice));
    const Light light = random_light(dice);
    const auto block = block_of(hits);
    light_hits(*block, {&light, 1});
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const Rgb expected = hits[i].lit_by(light);
      const Rgb sum = sum_of(*block, i).to_rgb();
      const Rgb at_stake = held(*block, 0, i).unpack();
      const float tolerance = 3e-5f * max_magnitude(expected) + 1e-10f;  // mantissas of 18 bits
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(sum[c], expected[c], tolerance);
        ASSERT_NEAR(at_stake[c], light.shadowless ? 0.0f : expected[c], tolerance);
      }
    }
  }
}

TEST(LightBlock, NothingDependsOnTheInstructionSetOrOnTheOtherHits) {
  Dice dice(2);
  std::vector<LitHit> hits;
  std::vector<Light> lights;
  for (std::size_t i = 0; i < kRaysAtOnce; ++i) hits.push_back(random_hit(dice));
  for (std::size_t l = 0; l < kLightsAtOnce; ++l) lights.push_back(random_light(dice));
  const auto light_all = [&](const std::vector<LitHit>& some) {
    const auto block = block_of(some);
    light_hits(*block, lights);
    return found(*block, lights.size());
  };
  const std::vector<std::int64_t> best = light_all(hits);
  for_each_instruction_set([&] {
    EXPECT_EQ(light_all(hits), best);
    std::vector<std::int64_t> one_by_one;
    for (const LitHit& hit : hits) {
      const std::vector<std::int64_t> one = light_all({hit});
      one_by_one.insert(one_by_one.end(), one.begin(), one.end());
    }
    EXPECT_EQ(one_by_one, best);
  });
}

TEST(LightBlock, NoFeelerIsHeldWhereItsEndIsForeseen) {
  Dice dice(7);
  std::vector<LitHit> hits;
  for (std::size_t i = 0; i < kRaysAtOnce; ++i) hits.push_back(random_hit(dice));
  std::vector<Light> lights(2);
  for (Light& light : lights) light.position = dice.point(9.0);
  const Foreseen foreseen{0x00ff00ff00ff00ffu, 0x0f000f000f000f00u};
  for_each_instruction_set([&] {
    const auto traced = block_of(hits);
    light_hits(*traced, lights);
    const auto block = block_of(hits);
    block->foreseen[1] = foreseen;
    light_hits(*block, lights);
    std::size_t clear = 0;
    std::size_t blocked = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const PackedRgb all = held(*traced, 1, i);
      const bool is_clear = (foreseen.clear >> i & 1u) != 0;
      const bool is_blocked = (foreseen.blocked >> i & 1u) != 0;
      FixedRgb expected = sum_of(*traced, i);
      if (is_blocked) expected -= FixedRgb::from(all);
      if (is_clear) {
        // Light that no feeler takes back has not been rounded to what a feeler can hold.
        FixedRgb difference = sum_of(*block, i);
        difference -= expected;
        EXPECT_LE(difference.max_magnitude(), (FixedRgb::from(all).max_magnitude() >> 17) + 2);
      } else {
        EXPECT_EQ(sum_of(*block, i), expected);
      }
      EXPECT_EQ(held(*block, 0, i).bits(), held(*traced, 0, i).bits());
      EXPECT_EQ(held(*block, 1, i).bits(), is_clear || is_blocked ? 0 : all.bits());
      clear += is_clear && all.bits() != 0;
      blocked += is_blocked && all.bits() != 0;
    }
    EXPECT_GT(blocked, 4u);
    EXPECT_EQ(block->clear_feelers, clear);
    EXPECT_EQ(block->blocked_feelers, blocked);
  });
}

TEST(LightBlock, WhatIsAddedIsWhatTheFeelersHold) {
  Dice dice(3);
  std::vector<LitHit> hits;
  for (std::size_t i = 0; i < kRaysAtOnce; ++i) hits.push_back(random_hit(dice));
  // From absurdly dark to absurdly bright.
  for (const float strength : {1e-38f, 1e-12f, 1e-6f, 1.0f, 1e4f, 1e9f, 1e30f}) {
    std::vector<Light> lights(RayTask::kMostFeelers);
    for (Light& light : lights) {
      light.position = dice.point(9.0);
      light.color = dice.color() * strength;
    }
    for_each_instruction_set([&] {
      const auto block = block_of(hits);
      light_hits(*block, lights);
      for (std::size_t i = 0; i < hits.size(); ++i) {
        FixedRgb sum;
        RayTask record;
        bool any = false;
        for (std::uint32_t l = 0; l < lights.size(); ++l) {
          const PackedRgb at_stake = held(*block, l, i);
          sum += FixedRgb::from(at_stake);
          if (at_stake.bits() == 0) continue;
          if (any) {
            ASSERT_TRUE(record.add_feeler(l, at_stake));
          } else {
            record.set_feeler(l, at_stake);
          }
          any = true;
        }
        ASSERT_EQ(sum, sum_of(*block, i));
        const RadianceBound bound(*SceneBuilder().build());
        ASSERT_EQ(block->at_stake[i], any ? bound.at_stake(record) : 0);
      }
    });
  }
}

TEST(LightBlock, NoLightComesFromTheLightItselfNorFromWhatIsNoNumber) {
  Dice dice(4);
  LitHit hit = random_hit(dice);
  Light light;
  light.position = hit.point;
  const auto in_the_light = block_of({hit});
  light_hits(*in_the_light, {&light, 1});
  EXPECT_EQ(in_the_light->light[0][0], 0u);

  light.position = hit.point + hit.normal;
  hit.diffuse = 1.0;
  hit.color = Rgb(std::numeric_limits<float>::quiet_NaN());
  const auto no_number = block_of({hit});
  light_hits(*no_number, {&light, 1});
  EXPECT_EQ(no_number->light[0][0], 0u);
  EXPECT_EQ(no_number->sum.of[0][0], 0);
}

TEST(LightBlock, DirectionsArePackedAndUnpackedAsOneByOne) {
  Dice dice(5);
  std::vector<LitHit> hits;
  for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
    LitHit hit = random_hit(dice);
    if (i < 6) {  // along an axis
      hit.direction = Vec3(0.0);
      hit.direction[static_cast<int>(i / 2)] = i % 2 == 0 ? 1.0 : -1.0;
      hit.normal = -hit.direction;
    }
    hits.push_back(hit);
  }
  for_each_instruction_set([&] {
    const auto block = block_of(hits);
    auto unpacked = std::make_unique<Columns3<double>>();
    unpack_directions(block->mirrored, hits.size(), *unpacked);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const Vec3& normal = hits[i].normal;
      const PackedDirection mirrored(hits[i].direction - normal * (2.0 * hits[i].direction.dot(normal)));
      ASSERT_EQ(block->mirrored[i], std::bit_cast<std::int64_t>(mirrored));
      ASSERT_EQ(unpacked->vector(i), mirrored.unpack());
    }
  });
}

TEST(FeelerBlock, FeelersAimAtTheirLightsAndKnowWhatTheyHold) {
  Dice dice(6);
  std::vector<LightPlace> places;
  for (int l = 0; l < 20; ++l) {
    const Vec3 at = dice.point(9.0);
    places.push_back({at.x, at.y, at.z});
  }
  for (const std::size_t count : {std::size_t{1}, std::size_t{37}, kRaysAtOnce}) {
    std::vector<Vec3> origins(count);
    std::vector<std::uint32_t> lights(count);
    std::vector<PackedRgb> held(count);
    for (std::size_t i = 0; i < count; ++i) {
      origins[i] = dice.point(5.0);
      lights[i] = static_cast<std::uint32_t>(dice.below(20));
      held[i] = PackedRgb(dice.color() * static_cast<float>(dice.between(-1.0, 1.0)));
    }
    for_each_instruction_set([&] {
      auto block = std::make_unique<FeelerBlock>();
      for (std::size_t i = 0; i < count; ++i) block->add(origins[i], lights[i], held[i]);
      // The entry behind the last feeler is anything.
      if (count < kRaysAtOnce) block->light[count] = std::numeric_limits<std::int64_t>::max() / 8;
      aim_feelers(*block, places);
      weigh_feelers(*block);
      ASSERT_EQ(block->size(), count);
      for (std::size_t i = 0; i < count; ++i) {
        const LightPlace& place = places[lights[i]];
        const Vec3 way = Vec3(place[0], place[1], place[2]) - origins[i];
        EXPECT_NEAR((block->rays.direction.vector(i) - way.normalized()).length(), 0.0, 1e-15);
        EXPECT_EQ(block->rays.origin.vector(i), origins[i]);
        EXPECT_EQ(block->rays.min_depth[i], kShadowGap);
        EXPECT_DOUBLE_EQ(block->rays.max_depth[i], way.length() - kShadowGap);
        EXPECT_EQ(FixedRgb::from(held[i]),
                  (FixedRgb{block->steps.of[0][i], block->steps.of[1][i], block->steps.of[2][i]}));
      }
    });
  }
}

}  // namespace
}  // namespace firstlight::render
