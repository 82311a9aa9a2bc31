#include "priority/tile_source.h"
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
    tiles.emplace(rays, film,
                  render::PrimaryTiles(kSide, kSide, 0.5, render::PrimaryTiles::Order::coarse_to_fine));
  }

  MirrorRoom room{/*depth=*/0};
  render::TraceContext context = room.context();
  render::PrimaryRays rays{context.scene, context.media, {context.camera(), kSide, kSide}};
  render::Film film;
  std::optional<TileSource> tiles;
};

/// Pixels between the points of the tile that roots are of, from its last row.
int stride_of(const Roots& roots) {
  const auto& tasks = roots.rays.tasks;
  return static_cast<int>(tasks[tasks.size() - 1].sample - tasks[tasks.size() - 2].sample);
}

TEST(TileSource, EveryPixelComesOnceWhoeverAsks) {
  for (const int threads : {1, 2, 3, 100}) {
    Dealt dealt(threads);
    std::vector<int> times(kSide * kSide);
    Roots roots;
    for (std::size_t turn = 0; dealt.tiles->next(turn % static_cast<std::size_t>(threads), roots); ++turn) {
      for (const render::RayTask& task : roots.rays.tasks) ++times[task.sample];
    }
    EXPECT_TRUE(std::ranges::all_of(times, [](int count) { return count == 1; })) << threads;
    EXPECT_EQ(dealt.tiles->top(), kNoSlot);
  }
}

TEST(TileSource, AWorkerGetsItsOwnPixelsBeforeThoseOfOthersThatAreEquallyCoarse) {
  Dealt dealt(2);
  Roots roots;
  int last_stride = kSide;
  bool last_was_own = true;
  while (dealt.tiles->next(1, roots)) {
    const int stride = stride_of(roots);
    const bool own = dealt.film.owner_of(roots.rays.tasks.front().sample) == 1;
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
