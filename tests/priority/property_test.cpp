// The order is free: whatever the order, the mixture, the threads, the memory, the size of the blocks and what the user
// does meanwhile, the picture ends in the same bytes.

#include "priority/driver.h"
#include "tests/priority/random_order.h"
#include "tests/priority/small_scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace firstlight::priority {
namespace {

// No multiples of a tile.
#ifdef FIRSTLIGHT_SANITIZED
constexpr int kWidth = 19;  // everything takes many times as long
constexpr int kHeight = 17;
constexpr std::uint32_t kSeeds = 250;
#else
constexpr int kWidth = 43;
constexpr int kHeight = 31;
constexpr std::uint32_t kSeeds = 400;
#endif

const std::vector<render::AntialiasSettings>& ways_of_antialiasing() {
  static const std::vector<render::AntialiasSettings> kWays{
      {.method = 1, .threshold = 0.2, .depth = 2, .jitter = false},
      {.method = 1, .threshold = 0.1, .depth = 2, .jitter = true, .block_size = 16},
      {.method = 2, .threshold = 0.1, .depth = 2, .jitter = false},
  };
  return kWays;
}

struct Finished {
  std::vector<render::Rgb> colors;
  render::RayCounts rays;
};

/// The traditional order with one thread. `antialias`: one of the ways, -1: none.
Finished reference_of(SmallScene& scene, int antialias) {
  render::Film film(kWidth, kHeight);
  TraceOptions options;
  if (antialias >= 0) options.antialias = &ways_of_antialiasing()[static_cast<std::size_t>(antialias)];
  const TraceResult result = trace(scene.context(), film, options);
  EXPECT_TRUE(result.complete()) << result.error;
  return {film.snapshot(), result.statistics.rays};
}

class Looking final : public Observer {
 public:
  void save(const Progress&) override { ++saves; }
  void first_image(const Progress&) override { ++first_images; }
  int saves = 0;
  int first_images = 0;
};

class AnyOrder : public testing::Test {
 protected:
  /// Renders with options chosen by `seed` and compares with the reference.
  void check(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto any_of = [&random](auto... values) {
      const std::common_type_t<decltype(values)...> all[]{values...};
      return all[random() % sizeof...(values)];
    };
    const std::size_t scene_number = random() % scenes_.size();
    SmallScene& scene = scenes_[scene_number];
    const int antialias = static_cast<int>(random() % 6) - 3;  // half of them without
    const std::string text = random_order(random);
    TraceOptions options;
    if (antialias >= 0) options.antialias = &ways_of_antialiasing()[static_cast<std::size_t>(antialias)];
    options.threads = any_of(1, 2, 2, 3, 4);
    options.block_size = any_of(0u, 0u, 1u, 16u, 100u, 1024u);
    options.queue_memory = any_of(std::size_t{0}, kSmallestQueueMemory, 2 * kSmallestQueueMemory, std::size_t{1} << 20);
    if (options.queue_memory != 0 && options.block_size > BlockPool::kSmallestBlock) options.block_size = 0;
    const bool steered = random() % 3 != 0;
    SCOPED_TRACE(fmt::format("seed {}: {}, '{}'{}, {} threads, blocks of {}, {} bytes, anti-aliasing {}", seed,
                             scene.name(), text, steered ? " and steered" : "", options.threads, options.block_size,
                             options.queue_memory, antialias));

    std::string error;
    const auto order = Order::parse(text, {.scene = index_of(scene.scene()), .width = kWidth, .height = kHeight}, error);
    ASSERT_TRUE(order) << error;
    Steering steering(*order);
    const std::shared_ptr<const Scheme> scheme = order->scheme();
    Looking looking;
    options.observer = &looking;
    std::atomic<bool> done = false;
    std::thread user;
    if (steered) {
      options.steering = &steering;
      user = std::thread([&steering, &done, own = std::mt19937(seed + 1)]() mutable {
        EXPECT_EQ(steer_at_random(steering, own, done), 0);
      });
    } else {
      options.scheme = scheme.get();
    }
    render::Film film(kWidth, kHeight);
    const TraceResult result = trace(scene.context(), film, options);
    done = true;
    if (user.joinable()) user.join();

    const Finished& reference = reference_for(scene_number, antialias);
    ASSERT_TRUE(result.complete()) << result.error;
    EXPECT_EQ(film.snapshot(), reference.colors);
    EXPECT_EQ(result.statistics.rays.by_kind, reference.rays.by_kind);
    EXPECT_EQ(looking.first_images, 1);
    if (options.queue_memory != 0) {
      EXPECT_LE(result.statistics.peak_bytes, options.queue_memory);
    }
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) ASSERT_EQ(film.outstanding(x, y), 0.0) << x << ", " << y;
    }
    saves_ += looking.saves;
    rekeyed_ += result.statistics.rekeying.rays;
  }

  const Finished& reference_for(std::size_t scene, int antialias) {
    const auto key = std::pair(scene, std::max(antialias, -1));
    const auto known = references_.find(key);
    if (known != references_.end()) return known->second;
    return references_.emplace(key, reference_of(scenes_[scene], antialias)).first->second;
  }

  std::vector<SmallScene> scenes_ = small_scenes();
  std::map<std::pair<std::size_t, int>, Finished> references_;
  int saves_ = 0;
  std::uint64_t rekeyed_ = 0;
};

TEST_F(AnyOrder, EndsInTheSameBytes) {
  for (std::uint32_t seed = 1; seed <= kSeeds && !HasFailure(); ++seed) check(seed);
  EXPECT_GT(saves_, 0);
  EXPECT_GT(rekeyed_, 0u);
}

}  // namespace
}  // namespace firstlight::priority
