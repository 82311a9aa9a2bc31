#include "priority/driver.h"

#include "priority/block_pool.h"
#include "priority/order.h"
#include "priority/schemes.h"
#include "tests/priority/mirror_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <thread>
#include <vector>

namespace firstlight::priority {
namespace {

constexpr int kWidth = 83;  // no multiple of the tiles
constexpr int kHeight = 61;

struct Rendered {
  std::vector<render::Rgb> colors;
  TraceResult result;
};

std::shared_ptr<const Scheme> scheme_of(MirrorRoom& room, std::string_view text) {
  std::string error;
  const auto order = Order::parse(text, {index_of(room.scene()), kWidth, kHeight}, error);
  EXPECT_TRUE(order) << error;
  return order->scheme();
}

Rendered render_with(MirrorRoom& room, std::string_view scheme_text, int threads, TraceOptions options = {}) {
  const auto scheme = scheme_of(room, scheme_text);
  options.scheme = scheme.get();
  options.threads = threads;
  render::Film film(kWidth, kHeight);
  Rendered rendered;
  rendered.result = trace(room.context(), film, options);
  rendered.colors = film.snapshot();
  return rendered;
}

TEST(Driver, EverySchemeAndThreadCountEndsInTheSamePicture) {
  MirrorRoom room(/*depth=*/2);
  const Rendered reference = render_with(room, "recursive", 1);
  ASSERT_TRUE(reference.result.complete()) << reference.result.error;
  const render::RayCounts& rays = reference.result.statistics.rays;
  ASSERT_EQ(rays.of(render::RayKind::primary), static_cast<std::uint64_t>(kWidth * kHeight));
  ASSERT_GT(rays.of(render::RayKind::reflection), 1000u);
  ASSERT_GT(rays.of(render::RayKind::transmission), 100u);
  ASSERT_GT(rays.of(render::RayKind::shadow), 1000u);
  for (const SchemeRow& row : schemes()) {
    if (row.name == "expr") continue;  // its compiler is the parser's; tests/golden renders with it
    for (const int threads : {1, 2, 3, 8}) {
      const Rendered other = render_with(room, row.example, threads);
      EXPECT_TRUE(other.result.complete()) << other.result.error;
      EXPECT_TRUE(other.colors == reference.colors) << row.name << ", " << threads << " threads";
      EXPECT_EQ(other.result.statistics.rays.by_kind, rays.by_kind) << row.name << ", " << threads << " threads";
    }
  }
}

TEST(Driver, AQueueBudgetIsKeptAndThePictureIsTheSame) {
  MirrorRoom room(/*depth=*/2);
  const Rendered reference = render_with(room, "recursive", 1);
  for (const char* scheme : {"contribution", "level"}) {
    const std::size_t unbounded = render_with(room, scheme, 2).result.statistics.peak_bytes;
    for (const std::size_t budget : {kSmallestQueueMemory, 4 * kSmallestQueueMemory, 10 * kSmallestQueueMemory}) {
      TraceOptions options;
      options.queue_memory = budget;
      const Rendered bounded = render_with(room, scheme, 2, options);
      EXPECT_TRUE(bounded.colors == reference.colors) << scheme;
      EXPECT_LE(bounded.result.statistics.peak_bytes, budget) << scheme;
      EXPECT_GT(bounded.result.statistics.peak_bytes, std::min(budget, unbounded) / 4) << scheme;
    }
  }
}

/// Counts the checkpoints and looks whether anything moves meanwhile.
struct Checkpoints final : Observer {
  explicit Checkpoints(const render::Film& of) : film(of) {}
  void checkpoint(const Progress& progress) override {
    EXPECT_GT(progress.traced.total(), last);
    last = progress.traced.total();
    const std::vector<render::Rgb> before = film.snapshot();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_TRUE(film.snapshot() == before) << "a worker did not rest";
    ++count;
  }
  static constexpr std::uint64_t kEvery = 5000;
  const render::Film& film;
  std::uint64_t last = 0;
  int count = 0;
};

TEST(Driver, AllWorkersRestAtCheckpoints) {
  MirrorRoom room(/*depth=*/2);
  for (const char* name : {"contribution", "recursive"}) {
    for (const int threads : {1, 3}) {
      render::Film film(kWidth, kHeight);
      Checkpoints checkpoints(film);
      const auto scheme = scheme_of(room, name);
      TraceOptions options;
      options.scheme = scheme.get();
      options.threads = threads;
      options.observer = &checkpoints;
      options.checkpoint_rays = Checkpoints::kEvery;
      const TraceResult result = trace(room.context(), film, options);
      EXPECT_TRUE(result.complete()) << result.error;
      EXPECT_GT(checkpoints.count, 5) << name << ", " << threads << " threads";
      EXPECT_EQ(result.statistics.remaining, 0.0);
    }
  }
}

TEST(Driver, EndsAtTheErrorThatIsAskedFor) {
  MirrorRoom room(/*depth=*/3, /*glass=*/0, /*max_trace_level=*/30);  // not done before the first look at the error
  TraceOptions options;
  options.stop_at_error = 1e9;
  const Rendered at_once = render_with(room, "contribution", 1, options);
  EXPECT_EQ(at_once.result.end, End::error_reached);
  EXPECT_GT(at_once.result.statistics.remaining, 0.0);
}

TEST(Driver, EndsWhenTheTimeIsOver) {
  MirrorRoom room(/*depth=*/3, /*glass=*/0, /*max_trace_level=*/30);
  TraceOptions options;
  options.stop_after = 1e-6;
  const Rendered short_of = render_with(room, "contribution", 1, options);
  EXPECT_EQ(short_of.result.end, End::time_over);
  EXPECT_LT(short_of.result.statistics.seconds, 2.0);
}

TEST(Driver, StatisticsDescribeTheQueue) {
  MirrorRoom room(/*depth=*/1);
  const TraceStatistics queued = render_with(room, "contribution", 1).result.statistics;
  EXPECT_GT(queued.peak_rays, 0u);
  EXPECT_LE(queued.peak_rays, queued.worst_case_rays);
  EXPECT_NEAR(queued.bytes_per_ray * static_cast<double>(queued.peak_rays), static_cast<double>(queued.peak_bytes),
              1.0);
  EXPECT_TRUE(queued.first_image.has_value());
  const TraceStatistics recursive = render_with(room, "recursive", 1).result.statistics;
  EXPECT_EQ(recursive.peak_rays, 0u);
  EXPECT_TRUE(recursive.first_image.has_value());
}

TEST(Driver, WorstCaseIsThePapersFormulaAndSaturates) {
  EXPECT_EQ(worst_case_rays(10, 3, 5), 10u * 3u * 63u);
  EXPECT_EQ(worst_case_rays(10, 0, 1), 30u);
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(worst_case_rays(1, 1, 62), (std::uint64_t{1} << 63) - 1);
  EXPECT_EQ(worst_case_rays(1, 1, 63), kMost);
  EXPECT_EQ(worst_case_rays(1000, 1000, 61), kMost);
}

TEST(Driver, StopsWhenAskedTo) {
  MirrorRoom room(/*depth=*/2);
  const std::atomic<bool> stop = true;
  TraceOptions options;
  options.stop = &stop;
  for (const char* scheme : {"contribution", "recursive"}) {
    const Rendered stopped = render_with(room, scheme, 2, options);
    EXPECT_FALSE(stopped.result.complete()) << scheme;
    EXPECT_EQ(stopped.result.error, "") << scheme;
    EXPECT_EQ(stopped.result.statistics.rays.total(), 0u) << scheme;
  }
}

/// Asks for an end when the first image is there.
struct StopAtFirstImage final : Observer {
  void first_image(const Progress& progress) override {
    ++calls;
    EXPECT_EQ(progress.tiles_done, progress.tiles);
    stop.store(true);
  }
  int calls = 0;
  std::atomic<bool> stop = false;
};

TEST(Driver, TellsOfTheFirstImageOnce) {
  MirrorRoom room(/*depth=*/1);
  for (const char* scheme : {"contribution", "recursive"}) {
    StopAtFirstImage observer;
    TraceOptions options;
    options.observer = &observer;
    options.stop = &observer.stop;
    const Rendered rendered = render_with(room, scheme, 2, options);
    EXPECT_EQ(observer.calls, 1) << scheme;
    EXPECT_TRUE(rendered.result.statistics.first_image.has_value()) << scheme;
  }
}

/// A scheme that fails in the middle of the work.
class Failing final : public Scheme {
 public:
  void keys(std::span<const render::RayTask>, std::span<Key> keys) const override {
    if (++calls_ == 10) throw std::bad_alloc();
    std::ranges::fill(keys, Key{1});
  }
  Key key_count() const override { return 2; }

 private:
  mutable std::atomic<int> calls_ = 0;
};

TEST(Driver, AFailureInAWorkerEndsInAMessage) {
  MirrorRoom room(/*depth=*/1);
  for (const int threads : {1, 3}) {
    const Failing scheme;
    TraceOptions options;
    options.scheme = &scheme;
    options.threads = threads;
    render::Film film(kWidth, kHeight);
    const TraceResult result = trace(room.context(), film, options);
    EXPECT_FALSE(result.complete());
    EXPECT_EQ(result.error, "not enough memory");
  }
}

}  // namespace
}  // namespace firstlight::priority
