#include "priority/blocked_shares.h"
#include "priority/ray_gains.h"
#include "priority/running_ratio.h"
#include "tests/priority/order_support.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>
#include <vector>

namespace firstlight::priority {
namespace {

using render::FixedRgb;
using render::PackedRgb;
using render::RayKind;
using render::RayTask;
using render::Rgb;

Key key_by_contribution(const RayTask& of) { return key_of(*scheme_of("contribution"), of); }

TEST(Contribution, ALargerWeightLeavesFirst) {
  float weight = 1e-6f;
  for (int step = 0; step < 200; ++step, weight *= 1.07f) {
    EXPECT_LE(key_by_contribution(task(RayKind::reflection, weight)),
              key_by_contribution(task(RayKind::reflection, weight * 1.07f)))
        << weight;
    EXPECT_LT(key_by_contribution(task(RayKind::reflection, weight)),
              key_by_contribution(task(RayKind::reflection, weight * 1.5f)))
        << weight;
  }
}

TEST(Contribution, HasTwoKeysToAnOctaveAndForFeelersOneToTwo) {
  EXPECT_EQ(key_by_contribution(task(RayKind::reflection, 0.25f)) + 2,
            key_by_contribution(task(RayKind::reflection, 0.5f)));
  EXPECT_EQ(key_by_contribution(task(RayKind::shadow, 0.125f)) + 4, key_by_contribution(task(RayKind::shadow, 0.5f)));
  EXPECT_EQ(key_by_contribution(task(RayKind::shadow, 0.25f)) % 4, 0u);
}

TEST(Contribution, CountsTheLightAtStakeForEachFeelerWhateverItsSign) {
  EXPECT_EQ(key_by_contribution(task(RayKind::shadow, -0.3f)), key_by_contribution(task(RayKind::shadow, 0.3f)));
  RayTask record = task(RayKind::shadow, 0.4f);
  ASSERT_TRUE(record.add_feeler(1, PackedRgb(Rgb(0.2f, 0.4f, 0.1f))));
  EXPECT_EQ(key_by_contribution(record), key_by_contribution(task(RayKind::shadow, 0.4f)));
  RayTask with_faint = task(RayKind::shadow, 0.4f);
  ASSERT_TRUE(with_faint.add_feeler(2, PackedRgb(Rgb(0.0f))));
  EXPECT_LT(key_by_contribution(with_faint), key_by_contribution(task(RayKind::shadow, 0.4f)));
}

/// Feelers of which those at the left are blocked and those at the right are not.
TEST(Contribution, LearnsWhereFeelersAreBlocked) {
  const auto scheme = scheme_of("contribution");
  std::vector<RayTask> tasks;
  std::vector<render::Contribution> light;
  for (int i = 0; i < 1600; ++i) {
    const bool left = i % 96 < 48;
    tasks.push_back(task(RayKind::shadow, 0.5f, 1, left ? 3 : 90, 10));
    FixedRgb change;
    if (left) change -= FixedRgb::from(PackedRgb(Rgb(0.5f)));
    light.push_back({tasks.back().sample, change, 0});
  }
  const Key before = key_of(*scheme, tasks[0]);
  scheme->learn(tasks, light, {});
  EXPECT_GT(key_of(*scheme, tasks[0]), before + 1);
  EXPECT_LT(key_of(*scheme, tasks[48]), before - 2);
  EXPECT_EQ(key_of(*scheme, task(RayKind::shadow, 0.5f, 1, 50, 70)), before) << "elsewhere nothing is known";
}

TEST(BlockedShares, TellFeelersOfOneRecordApart) {
  const Cells cells(scene_input());
  BlockedShares shares(cells, 3);
  RayTask record = task(RayKind::shadow, 0.5f, 1);
  ASSERT_TRUE(record.add_feeler(1, PackedRgb(Rgb(0.3f))));
  FixedRgb taken;
  taken -= FixedRgb::from(PackedRgb(Rgb(0.3f)));
  const std::size_t cell = cells.of(record);
  for (int i = 0; i < 100; ++i) shares.learn(cell, record, taken);
  const std::size_t base = shares.base(cell, record);
  EXPECT_LT(shares.share(base, 0), 0.05f);
  EXPECT_GT(shares.share(base, 1), 0.95f);
  EXPECT_EQ(shares.share(base, 2), shares.share(shares.base(cell + 1, record), 2)) << "nothing is known of it";
}

TEST(BlockedShares, TakeWhatIsPartlyBlockedForAShare) {
  const Cells cells(scene_input());
  BlockedShares shares(cells, 1);
  const RayTask feeler = task(RayKind::shadow, 0.5f, 1);
  for (int i = 0; i < 1000; ++i) shares.learn(0, feeler, FixedRgb::from(Rgb(-0.0625f, -0.125f, -0.0625f)));
  EXPECT_NEAR(shares.share(shares.base(0, feeler), 0), 0.25f, 0.01f);
}

TEST(RayGains, AMirrorIsWorthWhatItShows) {
  const Cells cells(scene_input());
  RayGains gains(cells);
  const float before = gains.gain(0, task(RayKind::reflection, 1.0f, 1));
  EXPECT_EQ(gains.gain(1, task(RayKind::reflection, 1.0f, 1)), before);
  RayTask on_mirror = task(RayKind::reflection, 0.5f, 1);
  on_mirror.set_weight(Rgb(0.5f), 1.0f);
  RayTask behind = task(RayKind::reflection, 0.5f, 2);
  behind.set_weight(Rgb(0.5f), 1.0f);
  for (int i = 0; i < 1000; ++i) {
    gains.learn_traced(0, on_mirror, FixedRgb());
    gains.learn_spawned(0, behind);
    gains.learn_traced(0, behind, FixedRgb::from(Rgb(0.4f)));
  }
  EXPECT_NEAR(gains.gain(0, behind), 0.8f, 0.02f) << "0.4 of light for a weight of 0.5";
  EXPECT_NEAR(gains.gain(0, on_mirror), 0.4f, 0.02f) << "two rays for it";
  EXPECT_EQ(gains.gain(1, on_mirror), before);
}

TEST(RayGains, OddLightDoesNoHarm) {
  const Cells cells(scene_input());
  RayGains gains(cells);
  for (const float odd :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f, -1e30f}) {
    RayTask ray = task(RayKind::reflection, odd, 1);
    gains.learn_traced(0, ray, FixedRgb::from(Rgb(1.0f)));
    gains.learn_spawned(0, ray);
    gains.learn_traced(0, task(RayKind::reflection, 0.0f, 1), FixedRgb::from(Rgb(odd)));
    gains.learn_traced(0, task(RayKind::reflection, 0.5f, 1), FixedRgb::from(Rgb(odd)));
  }
  const float gain = gains.gain(0, task(RayKind::reflection, 0.5f, 1));
  EXPECT_GE(gain, 0.0f);
  EXPECT_LE(gain, 20.0f);
}

TEST(RunningRatio, FollowsWhatItSees) {
  RunningRatio ratio;
  EXPECT_FLOAT_EQ(ratio.estimate(0.4f, 4.0f), 0.4f);
  ratio.add(1.0f, 1.0f);
  EXPECT_FLOAT_EQ(ratio.estimate(0.4f, 4.0f), 2.6f / 5.0f);
  for (int i = 0; i < 10000; ++i) ratio.add(i % 4 == 0 ? 1.0f : 0.0f, 1.0f);
  EXPECT_NEAR(ratio.estimate(0.4f, 1.0f), 0.25f, 0.02f);
  for (int i = 0; i < 2000; ++i) ratio.add(1.0f, 1.0f);
  EXPECT_GT(ratio.estimate(0.4f, 1.0f), 0.95f) << "what is old fades";
}

TEST(RunningRatio, StaysBelievableWhenManyAddAtOnce) {
  RunningRatio ratio;
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&ratio] {
        for (int i = 0; i < 20000; ++i) ratio.add(0.5f, 1.0f);
      });
    }
  }
  EXPECT_NEAR(ratio.estimate(0.5f, 1.0f), 0.5f, 1e-3f);
}

}  // namespace
}  // namespace firstlight::priority
