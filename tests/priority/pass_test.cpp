// Sources and sinks that are no picture, traced with one.

#include "priority/driver.h"
#include "priority/film_sink.h"
#include "priority/order.h"
#include "priority/round_source.h"
#include "priority/schemes.h"
#include "priority/tile_source.h"
#include "tests/priority/mirror_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <string_view>
#include <vector>

namespace firstlight::priority {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;
constexpr std::uint32_t kCells = 6;
constexpr std::array<int, 3> kRaysOfRounds{50, 1, 200};

/// A sink as a map might be: sums of light by cell, which tell no progress.
class Map final : public Sink {
 public:
  std::uint64_t samples() const override { return 0; }
  void expect(std::int64_t) override {}
  void add(std::span<const render::Contribution> light) override {
    const std::lock_guard lock(mutex_);
    for (const auto& [sample, sum, outstanding] : light) cells_.at(sample) += sum;
  }
  const std::array<render::FixedRgb, kCells>& cells() const { return cells_; }
  bool empty() const { return cells_ == std::array<render::FixedRgb, kCells>(); }

 private:
  std::mutex mutex_;
  std::array<render::FixedRgb, kCells> cells_;
};

/// Rounds of rays to the map; where the rays of a round go depends on what is on the map then.
class MapSource final : public RootSource {
 public:
  MapSource(const render::PrimaryRays& rays, const Map& map) : rays_(rays), map_(map) {}

  int top() const override { return left_.load() > 0 ? static_cast<int>(kSlots) - 1 : kNoSlot; }
  bool next(std::size_t, Roots& roots) override {
    roots.rays.clear();
    const int number = --left_;
    if (number < 0) return false;
    const double x = (number * 7 + shift_) % kWidth;
    const render::PrimaryPlace place{x, 1.0 + number % kHeight, static_cast<std::uint32_t>(number) % kCells};
    rays_.append({&place, 1}, roots.rays);
    return true;
  }
  bool refill() override {
    if (round_ == kRaysOfRounds.size()) return false;
    EXPECT_EQ(round_ == 0, map_.empty());
    const std::int64_t sum = std::accumulate(map_.cells().begin(), map_.cells().end(), std::int64_t{0},
                                             [](std::int64_t s, const render::FixedRgb& cell) { return s + cell.r; });
    shift_ = static_cast<int>(sum & 31);
    left_ = kRaysOfRounds[round_++];
    return true;
  }

 private:
  const render::PrimaryRays& rays_;
  const Map& map_;
  std::size_t round_ = 0;
  int shift_ = 0;
  std::atomic<int> left_ = 0;
};

/// One more sample for each pixel where the map has light, once.
class MapRounds final : public render::SampleRounds {
 public:
  explicit MapRounds(const Map& map) : map_(map) {}
  std::span<const render::SamplePoint> next() override {
    if (!points_.empty()) return {};
    for (std::uint32_t cell = 0; cell < kCells; ++cell) {
      if (map_.cells()[cell].r != 0) points_.push_back({cell + 0.25, 0.75, cell});
    }
    return points_;
  }

 private:
  const Map& map_;
  std::vector<render::SamplePoint> points_;
};

struct Traced {
  std::array<render::FixedRgb, kCells> map;
  std::vector<render::Rgb> picture;
  TraceResult result;
};

struct Watcher final : Observer {
  void preview(const Progress&) override { ++previews; }
  void first_image(const Progress& progress) override {
    ++first_images;
    EXPECT_EQ(progress.tiles_done, progress.tiles);
  }
  int previews = 0;
  int first_images = 0;
};

/// A map, then a picture, then samples that the map asks for: three sources, two sinks.
Traced trace_with(MirrorRoom& room, std::string_view scheme_text, int threads) {
  std::string error;
  const auto order = Order::parse(scheme_text, {index_of(room.scene()), kWidth, kHeight}, error);
  EXPECT_TRUE(order) << error;
  const render::TraceContext context = room.context();
  const render::PrimaryRays rays(context.scene, context.media, {context.camera(), kWidth, kHeight});
  render::Film film(kWidth, kHeight);
  film.deal_out(threads);
  Map map;
  FilmSink film_sink(film);
  MapSource map_source(rays, map);
  TileSource tiles(rays, film, render::PrimaryTiles(kWidth, kHeight, 0.5, render::PrimaryTiles::Order::coarse_to_fine));
  MapRounds map_rounds(map);
  RoundSource rounds(rays, map_rounds);
  const std::array<Pass, 3> passes{Pass{&map_source, &map}, Pass{&tiles, &film_sink}, Pass{&rounds, &film_sink}};
  Watcher watcher;
  TraceOptions options;
  options.scheme = order->scheme().get();
  options.threads = threads;
  options.observer = &watcher;
  Traced traced;
  traced.result = trace(context, passes, options);
  traced.map = map.cells();
  traced.picture = film.snapshot();
  EXPECT_EQ(watcher.previews, 1);
  EXPECT_EQ(watcher.first_images, 1);
  return traced;
}

TEST(Pass, EverySchemeAndThreadCountEndsInTheSameSinks) {
  MirrorRoom room(/*depth=*/1);
  const Traced reference = trace_with(room, "recursive", 1);
  ASSERT_TRUE(reference.result.complete()) << reference.result.error;
  const render::RayCounts& rays = reference.result.statistics.rays;
  const int of_map = std::accumulate(kRaysOfRounds.begin(), kRaysOfRounds.end(), 0);
  EXPECT_EQ(rays.of(render::RayKind::primary), static_cast<std::uint64_t>(kWidth * kHeight + of_map) + kCells);
  for (const SchemeRow& row : schemes()) {
    if (row.name == "expr") continue;  // its compiler is the parser's
    for (const int threads : {1, 3}) {
      const Traced other = trace_with(room, row.example, threads);
      EXPECT_TRUE(other.result.complete()) << other.result.error;
      EXPECT_TRUE(other.map == reference.map) << row.name << ", " << threads << " threads";
      EXPECT_TRUE(other.picture == reference.picture) << row.name << ", " << threads << " threads";
      EXPECT_EQ(other.result.statistics.rays.by_kind, rays.by_kind) << row.name << ", " << threads << " threads";
    }
  }
}

TEST(Pass, APictureIsTheSameWithAMapBeforeIt) {
  MirrorRoom room(/*depth=*/1);
  render::Film film(kWidth, kHeight);
  ASSERT_TRUE(trace(room.context(), film, {}).complete());
  const std::vector<render::Rgb> alone = film.snapshot();
  const Traced traced = trace_with(room, "contribution", 2);
  EXPECT_TRUE(std::equal(alone.begin() + kCells, alone.end(), traced.picture.begin() + kCells));
  EXPECT_FALSE(std::equal(alone.begin(), alone.begin() + kCells, traced.picture.begin()));
}

}  // namespace
}  // namespace firstlight::priority
