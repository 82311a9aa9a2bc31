#include "priority/steering.h"

#include "tests/priority/order_support.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

namespace firstlight::priority {
namespace {

using render::RayKind;
using render::RayTask;

Order order_of(std::string_view text) {
  std::string error;
  return *Order::parse(text, scene_input(), error);
}

Boost region(std::string name, const Rectangle& where, int by = 1) {
  Boost boost;
  boost.name = std::move(name);
  boost.region = where;
  boost.by = by;
  return boost;
}

Boost object(std::string name, std::string called, int by = 1) {
  Boost boost;
  boost.name = std::move(name);
  boost.kind = Boost::Kind::object;
  boost.object = std::move(called);
  boost.by = by;
  return boost;
}

Boost light(std::string name, int index, int by = 1) {
  Boost boost;
  boost.name = std::move(name);
  boost.kind = Boost::Kind::light;
  boost.light = index;
  boost.by = by;
  return boost;
}

TEST(Boosts, ALargerSumLeavesFirstAndTheSchemeOrdersWhatIsEqual) {
  Order order = order_of("level");
  EXPECT_EQ(order.add(region("left", {0, 0, 49, 79})), "");
  EXPECT_EQ(order.add(object("legs", "Leg", 2)), "");
  EXPECT_EQ(order.add(region("corner", {0, 0, 9, 9}, -4)), "");
  const auto scheme = order.scheme();
  const auto key = [&](int x, int level, std::uint16_t of) {
    RayTask ray = task(RayKind::reflection, 0.5f, level, x, 5);
    ray.object = of;
    return key_of(*scheme, ray);
  };
  EXPECT_GT(key(20, 5, 1), key(60, 0, 1)) << "both boosts before one";
  EXPECT_GT(key(60, 5, 1), key(20, 0, 0)) << "2 before 1";
  EXPECT_GT(key(20, 5, 0), key(60, 0, 0)) << "1 before 0";
  EXPECT_GT(key(60, 5, 0), key(5, 0, 1)) << "0 before -1";
  EXPECT_GT(key(5, 5, 1), key(5, 0, 0)) << "-1 before -3";
  EXPECT_GT(key(20, 1, 0), key(20, 2, 0)) << "the scheme";
  EXPECT_TRUE(scheme->tells_pixels_apart());
}

TEST(Boosts, OfALightCountForRecordsThatHoldOneOfItsFeelers) {
  Order order = order_of("contribution");
  ASSERT_EQ(order.add(light("sun", 2, 3)), "");
  RayTask both = task(RayKind::shadow, 0.1f);
  ASSERT_TRUE(both.add_feeler(2, render::PackedRgb(render::Rgb(0.1f))));
  EXPECT_GT(key_of(*order.scheme(), both), key_of(*order.scheme(), task(RayKind::shadow, 0.9f)));
  EXPECT_GT(key_of(*order.scheme(), both), key_of(*order.scheme(), task(RayKind::reflection, 0.9f)));
}

TEST(Boosts, AreReplacedAndDroppedByName) {
  Order order = order_of("level");
  EXPECT_EQ(order.add(region("a", {0, 0, 9, 9}, 1)), "");
  EXPECT_EQ(order.add(region("a", {0, 0, 9, 9}, -1)), "");
  EXPECT_EQ(order.boosts().size(), 1u);
  const auto key = [&](int x) { return key_of(*order.scheme(), task(RayKind::reflection, 0.5f, 2, x, 5)); };
  EXPECT_LT(key(5), key(15));
  EXPECT_FALSE(order.drop("b"));
  EXPECT_TRUE(order.drop("a"));
  EXPECT_EQ(key(5), key(15));
  EXPECT_EQ(order.scheme()->key_count(), order_of("level").scheme()->key_count());
}

TEST(Boosts, OfAnySizeAndNumberKeepTheirOrder) {
  Order order = order_of("contribution, level");
  constexpr int kMost = std::numeric_limits<int>::max();
  for (int i = 0; i < 12; ++i) ASSERT_EQ(order.add(region(std::to_string(i), {i, 0, 99, 79}, 1 << (2 * i))), "");
  ASSERT_EQ(order.add(region("most", {90, 0, 99, 79}, kMost)), "");
  ASSERT_EQ(order.add(region("least", {80, 0, 89, 79}, -kMost - 1)), "");
  const auto key = [&](int x) { return key_of(*order.scheme(), task(RayKind::reflection, 0.5f, 2, x, 5)); };
  EXPECT_LE(order.scheme()->key_count(), kBuckets);
  for (int x = 1; x < 12; ++x) EXPECT_GE(key(x), key(x - 1)) << x;
  EXPECT_GT(key(95), key(70));
  EXPECT_LT(key(85), key(0));
}

TEST(Boosts, ThatMeanNothingAreErrors) {
  Order order = order_of("level");
  EXPECT_EQ(order.add(object("a", "Chiar")), "the scene has no object 'Chiar' (the nearest is 'Chair')");
  EXPECT_EQ(order.add(light("a", 3)), "there is no light 3: the scene has 3, counted from 0");
  EXPECT_NE(order.add(light("a", -1)), "");
  EXPECT_NE(order.add(region("a", {5, 5, 4, 9})), "");
  EXPECT_NE(order.add(region("a", {100, 0, 120, 9})), "");
  EXPECT_NE(order.add(region("a", {-9, 0, -1, 9})), "");
  EXPECT_TRUE(order.boosts().empty());
}

TEST(Steering, CountsEachChangeOfTheOrderAndNothingElse) {
  Steering steering(order_of("level"));
  std::uint64_t version = steering.version();
  const auto changed = [&] { return std::exchange(version, steering.version()) != version; };
  EXPECT_EQ(steering.set_scheme("contribution"), "");
  EXPECT_TRUE(changed());
  EXPECT_NE(steering.set_scheme("contributio"), "");
  EXPECT_FALSE(changed());
  EXPECT_EQ(steering.order().text(), "contribution");
  EXPECT_EQ(steering.boost(region("a", {0, 0, 9, 9})), "");
  EXPECT_TRUE(changed());
  EXPECT_NE(steering.boost(light("b", 7)), "");
  EXPECT_FALSE(steering.drop("b"));
  steering.pause();
  steering.resume();
  steering.save();
  EXPECT_FALSE(changed());
  EXPECT_EQ(steering.set_scheme("level"), "");
  EXPECT_TRUE(changed());
  EXPECT_EQ(steering.order().boosts().size(), 1u) << "boosts outlive the scheme";
  EXPECT_TRUE(steering.drop("a"));
  EXPECT_TRUE(changed());
  steering.drop_all();
  EXPECT_FALSE(changed());
}

TEST(Steering, ThereIsNoWayFromOrToTheOrderWithoutAQueue) {
  Steering queued(order_of("level"));
  EXPECT_NE(queued.set_scheme("recursive"), "");
  EXPECT_NE(queued.scheme(), nullptr);
  Steering recursive(order_of("recursive"));
  EXPECT_NE(recursive.set_scheme("level"), "");
  EXPECT_EQ(recursive.set_scheme("recursive"), "");
}

TEST(Steering, ASaveIsAskedForOnce) {
  Steering steering(order_of("level"));
  EXPECT_FALSE(steering.take_save_request());
  steering.save();
  steering.save();
  EXPECT_TRUE(steering.take_save_request());
  EXPECT_FALSE(steering.take_save_request());
}

TEST(Steering, APauseHoldsUntilItIsOverOrTheRenderingStopped) {
  for (const bool stop : {false, true}) {
    Steering steering(order_of("level"));
    steering.wait_while_paused();
    steering.pause();
    EXPECT_TRUE(steering.paused());
    std::atomic<bool> over = false;
    std::jthread waiting([&] {
      steering.wait_while_paused();
      over = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_FALSE(over);
    if (stop) {
      steering.stop();
    } else {
      steering.resume();
    }
    waiting.join();
    EXPECT_TRUE(over);
    EXPECT_EQ(steering.stopped(), stop);
  }
}

TEST(Steering, MayBeAskedFromManyThreads) {
  Steering steering(order_of("level"));
  std::atomic<bool> done = false;
  std::jthread reader([&] {
    const RayTask ray = task(RayKind::reflection, 0.5f, 2, 5, 5);
    while (!done) {
      const std::uint64_t version = steering.version();
      EXPECT_LT(key_of(*steering.scheme(), ray), kBuckets);
      EXPECT_LE(version, steering.version());
    }
  });
  std::vector<std::jthread> writers;
  for (int w = 0; w < 3; ++w) {
    writers.emplace_back([&steering, w] {
      for (int i = 0; i < 200; ++i) {
        EXPECT_EQ(steering.set_scheme(i % 2 == 0 ? "contribution" : "level, distance"), "");
        EXPECT_EQ(steering.boost(region(std::to_string(w), {i % 50, 0, 60, 60}, w - 1)), "");
        if (i % 3 == 0) steering.drop(std::to_string(w));
      }
    });
  }
  writers.clear();
  done = true;
}

}  // namespace
}  // namespace firstlight::priority
