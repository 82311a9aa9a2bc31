#include "priority/schemes.h"
#include "priority/order.h"

#include <gtest/gtest.h>

#include <limits>

namespace firstlight::priority {
namespace {

using render::RayKind;
using render::RayTask;
using render::Rgb;

RayTask task(RayKind kind, float weight, int level = 0) {
  RayTask out;
  out.origin = render::Vec3(0.0);
  out.kind = kind;
  const Rgb light(weight * 0.5f, weight, weight * 0.25f);
  if (kind == RayKind::shadow) {
    out.set_feeler(0, render::PackedRgb(light));
  } else {
    out.radiance.set_weight(light);
  }
  out.level = static_cast<std::uint8_t>(level);
  return out;
}

Key key_of_task(std::string_view scheme, const RayTask& of) {
  static const render::Scene kScene = [] {
    render::Scene scene;
    scene.settings.max_trace_level = 255;
    return scene;
  }();
  std::string error;
  const auto made = Order::parse(scheme, {&kScene, 64, 64}, error)->scheme();
  Key key = kBuckets;
  made->keys({&of, 1}, {&key, 1});
  return key;
}

TEST(Schemes, AreFoundByTheirNames) {
  for (const SchemeRow& row : schemes()) {
    EXPECT_EQ(find_scheme(row.name), &row);
  }
  EXPECT_EQ(find_scheme("contributio"), nullptr);
  EXPECT_NE(find_scheme(kDefaultScheme), nullptr);
}

TEST(Schemes, GiveKeysWithinTheBuckets) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const SchemeRow& row : schemes()) {
    if (row.make == nullptr) continue;
    for (const float weight : {0.0f, -1.0f, 1e-45f, 1e38f, kInfinity, -kInfinity, kNan, -kNan}) {
      for (const RayKind kind : {RayKind::primary, RayKind::reflection, RayKind::transmission, RayKind::shadow}) {
        EXPECT_LT(key_of_task(row.name, task(kind, weight, 255)), kBuckets) << row.name << ' ' << weight;
      }
    }
  }
}

TEST(Contribution, ALargerWeightLeavesFirst) {
  float weight = 1e-6f;
  for (int step = 0; step < 300; ++step, weight *= 1.07f) {
    EXPECT_LT(key_of_task("contribution", task(RayKind::reflection, weight)),
              key_of_task("contribution", task(RayKind::reflection, weight * 1.07f)))
        << weight;
  }
}

TEST(Contribution, HasSixteenBucketsToAnOctave) {
  EXPECT_EQ(key_of_task("contribution", task(RayKind::shadow, 0.25f)) + 16,
            key_of_task("contribution", task(RayKind::shadow, 0.5f)));
}

TEST(Contribution, CountsWhatAFeelerCanTakeBackWhateverItsSign) {
  EXPECT_EQ(key_of_task("contribution", task(RayKind::shadow, -0.3f)),
            key_of_task("contribution", task(RayKind::shadow, 0.3f)));
  EXPECT_GT(key_of_task("contribution", task(RayKind::shadow, 0.3f)),
            key_of_task("contribution", task(RayKind::shadow, 0.1f)));
}

TEST(Level, FewerLevelsLeaveFirst) {
  for (int level = 0; level < 255; ++level) {
    EXPECT_GT(key_of_task("level", task(RayKind::reflection, 0.1f, level)),
              key_of_task("level", task(RayKind::transmission, 0.9f, level + 1)));
  }
}

TEST(RayType, ShadowsLeaveLast) {
  EXPECT_GT(key_of_task("ray-type", task(RayKind::primary, 0.1f)),
            key_of_task("ray-type", task(RayKind::reflection, 0.9f)));
  EXPECT_GT(key_of_task("ray-type", task(RayKind::reflection, 0.1f)),
            key_of_task("ray-type", task(RayKind::transmission, 0.9f)));
  EXPECT_GT(key_of_task("ray-type", task(RayKind::transmission, 0.1f)),
            key_of_task("ray-type", task(RayKind::shadow, 0.9f)));
}

}  // namespace
}  // namespace firstlight::priority
