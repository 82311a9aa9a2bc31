#include "priority/primary_order.h"
#include "priority/schemes.h"
#include "tests/priority/mirror_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace firstlight::priority {
namespace {

constexpr int kSide = 256;

/// The primary rays of a room, dealt out among some threads.
struct Dealt {
  explicit Dealt(int threads) : film(kSide, kSide) {
    film.deal_out(threads);
    order.emplace(room.context(), film, render::PrimaryTiles::Order::coarse_to_fine, nullptr);
  }

  MirrorRoom room{/*depth=*/0};
  render::Film film;
  std::optional<PrimaryOrder> order;
};

/// Pixels between the points of the tile that a batch is of, from its last row.
int stride_of(const PrimaryOrder::Batch& batch) {
  const auto& tasks = batch.rays.tasks;
  return static_cast<int>(tasks[tasks.size() - 1].sample - tasks[tasks.size() - 2].sample);
}

TEST(PrimaryOrder, EveryPixelComesOnceWhoeverAsks) {
  for (const int threads : {1, 2, 3, 100}) {
    Dealt dealt(threads);
    std::vector<int> times(kSide * kSide);
    PrimaryOrder::Batch batch;
    for (std::size_t turn = 0; dealt.order->next(turn % static_cast<std::size_t>(threads), batch); ++turn) {
      for (const render::RayTask& task : batch.rays.tasks) ++times[task.sample];
    }
    EXPECT_TRUE(std::ranges::all_of(times, [](int count) { return count == 1; })) << threads;
    EXPECT_EQ(dealt.order->top(), kNoSlot);
  }
}

TEST(PrimaryOrder, AWorkerGetsItsOwnPixelsBeforeThoseOfOthersThatAreEquallyCoarse) {
  Dealt dealt(2);
  PrimaryOrder::Batch batch;
  int last_stride = kSide;
  bool last_was_own = true;
  while (dealt.order->next(1, batch)) {
    const int stride = stride_of(batch);
    const bool own = dealt.film.owner_of(batch.rays.tasks.front().sample) == 1;
    ASSERT_LE(stride, last_stride);
    if (stride == last_stride && !last_was_own) {
      EXPECT_FALSE(own) << stride;
    }
    last_stride = stride;
    last_was_own = own;
  }
  EXPECT_EQ(last_stride, 1);
  EXPECT_FALSE(last_was_own);
}

}  // namespace
}  // namespace firstlight::priority
