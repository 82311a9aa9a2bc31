#include "render/trace/primary.h"

#include "render/scene/scene_builder.h"
#include "render/trace/medium_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace firstlight::render {
namespace {

class PrimaryTilesOf : public testing::TestWithParam<PrimaryTiles::Order> {};

TEST_P(PrimaryTilesOf, HaveEachPixelOnce) {
  // Sizes that are no multiples of a tile, among them.
  for (const auto& [width, height] : {std::pair(1, 1), {16, 16}, {17, 3}, {300, 261}, {256, 512}}) {
    const PrimaryTiles tiles(width, height, 0.5, GetParam());
    std::vector<std::uint32_t> samples;
    for (std::uint32_t tile = 0; tile < tiles.count(); ++tile) tiles.append_samples(tile, samples);
    std::ranges::sort(samples);
    std::vector<std::uint32_t> all(static_cast<std::size_t>(width * height));
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(samples, all) << width << "x" << height;
  }
}

TEST_P(PrimaryTilesOf, AreFilledWithTheRaysOfTheirSamples) {
  const auto scene = SceneBuilder().build();
  MediumTable media;
  const PrimaryRays rays(*scene, media, {scene->camera, 100, 70});
  const PrimaryTiles tiles(100, 70, 0.5, GetParam());
  for (std::uint32_t tile = 0; tile < tiles.count(); ++tile) {
    PrimaryBatch batch;
    std::vector<std::uint32_t> samples;
    tiles.fill(tile, rays, batch);
    tiles.append_samples(tile, samples);
    ASSERT_EQ(batch.rays.size(), samples.size());
    ASSERT_TRUE(std::ranges::equal(batch.tasks, samples, {}, &RayTask::sample));
    for (std::size_t i = 0; i < samples.size(); ++i) {
      PrimaryBatch one;
      const PrimaryPlace place{samples[i] % 100 + 0.5, samples[i] / 100 + 0.5, samples[i]};
      rays.append({&place, 1}, one);
      ASSERT_EQ(batch.rays[i].direction, one.rays[0].direction);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Order, PrimaryTilesOf,
                         testing::Values(PrimaryTiles::Order::coarse_to_fine, PrimaryTiles::Order::square_by_square));

}  // namespace
}  // namespace firstlight::render
