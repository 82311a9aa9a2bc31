// Memory is bounded: waiting rays take no more than they are given, and the picture is the same.

#include "priority/driver.h"
#include "priority/order.h"
#include "priority/schemes.h"
#include "tests/priority/mirror_room.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace firstlight::priority {
namespace {

#ifdef FIRSTLIGHT_SANITIZED
constexpr int kWidth = 30;  // everything takes many times as long
constexpr int kHeight = 20;
#else
constexpr int kWidth = 80;
constexpr int kHeight = 60;
#endif

class QueueMemory : public testing::Test {
 protected:
  TraceResult render_with(std::string_view text, std::size_t memory, int threads, std::vector<render::Rgb>& colors) {
    std::string error;
    const auto order = Order::parse(text, {.scene = index_of(room_.scene()), .width = kWidth, .height = kHeight}, error);
    EXPECT_TRUE(order) << error;
    const auto scheme = order->scheme();
    TraceOptions options;
    options.scheme = scheme.get();
    options.threads = threads;
    options.queue_memory = memory;
    render::Film film(kWidth, kHeight);
    TraceResult result = trace(room_.context(), film, options);
    EXPECT_TRUE(result.complete()) << result.error;
    colors = film.snapshot();
    return result;
  }

  // Many levels and lights: a pixel may have hundreds of rays waiting.
  MirrorRoom room_{/*depth=*/2, /*glass=*/3, /*max_trace_level=*/8, /*lights=*/4};
};

TEST_F(QueueMemory, IsKeptByEverySchemeWithAnyNumberOfThreads) {
  std::vector<render::Rgb> reference;
  const TraceResult recursive = render_with("recursive", 0, 1, reference);
  for (const SchemeRow& row : schemes()) {
    if (row.make == nullptr || row.name == "expr") continue;  // no queue; needs a compiler
    for (const std::size_t memory : {kSmallestQueueMemory, 4 * kSmallestQueueMemory}) {
      for (const int threads : {1, 2, 4}) {
        SCOPED_TRACE(fmt::format("{}, {} bytes, {} threads", row.name, memory, threads));
        std::vector<render::Rgb> colors;
        const TraceResult result = render_with(row.example, memory, threads, colors);
        EXPECT_LE(result.statistics.peak_bytes, memory);
        EXPECT_EQ(result.statistics.rays.by_kind, recursive.statistics.rays.by_kind);
        EXPECT_EQ(colors, reference);
      }
    }
  }
}

TEST_F(QueueMemory, WouldBeExceededManyTimesWithoutABudget) {
  constexpr std::size_t kMany = kWidth * kHeight / 1000;
  std::vector<render::Rgb> colors;
  EXPECT_GT(render_with("level", 0, 1, colors).statistics.peak_bytes, kMany * kSmallestQueueMemory);
  EXPECT_GT(render_with("ray-type", 0, 1, colors).statistics.peak_bytes, kMany * kSmallestQueueMemory);
}

TEST_F(QueueMemory, OfNothingMeansThatNothingWaits) {
  std::vector<render::Rgb> reference;
  std::vector<render::Rgb> colors;
  render_with("recursive", 0, 1, reference);
  const TraceResult result = render_with("contribution", 1, 2, colors);
  EXPECT_EQ(result.statistics.peak_bytes, 0u);
  EXPECT_EQ(colors, reference);
}

}  // namespace
}  // namespace firstlight::priority
