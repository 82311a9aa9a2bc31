#include "render/trace/medium_table.h"

#include <gtest/gtest.h>

namespace firstlight::render {
namespace {

TEST(MediumTable, OutsideContainsNothing) {
  const MediumTable media;
  EXPECT_FALSE(media.contains(MediumTable::kOutside, 0));
  EXPECT_EQ(media.innermost(MediumTable::kOutside), MediumTable::kNone);
  EXPECT_EQ(media.depth(MediumTable::kOutside), 0u);
}

TEST(MediumTable, EqualWaysGiveEqualStacks) {
  MediumTable media;
  const std::uint32_t glass = media.entered(MediumTable::kOutside, 3);
  EXPECT_EQ(media.entered(MediumTable::kOutside, 3), glass);
  EXPECT_NE(media.entered(MediumTable::kOutside, 4), glass);
}

TEST(MediumTable, LeavingTheInnermostUndoesEntering) {
  MediumTable media;
  const std::uint32_t glass = media.entered(MediumTable::kOutside, 3);
  const std::uint32_t water = media.entered(glass, 5);
  EXPECT_EQ(media.innermost(water), 5u);
  EXPECT_EQ(media.depth(water), 2u);
  EXPECT_EQ(media.left(water, 5), glass);
}

TEST(MediumTable, LeavingAnOuterOneKeepsTheRestInOrder) {
  MediumTable media;
  const std::uint32_t three = media.entered(media.entered(media.entered(MediumTable::kOutside, 1), 2), 3);
  const std::uint32_t two = media.left(three, 1);
  EXPECT_EQ(two, media.entered(media.entered(MediumTable::kOutside, 2), 3));
  EXPECT_FALSE(media.contains(two, 1));
  EXPECT_TRUE(media.contains(two, 2));
}

TEST(MediumTable, LightKeepsItsBandThroughMatter) {
  MediumTable media;
  const SpectralBand violet{0, 7};
  const SpectralBand red{6, 7};
  const std::uint32_t inside = media.entered(media.entered(MediumTable::kOutside, 3), 5);
  EXPECT_TRUE(media.band(inside).is_white());
  const std::uint32_t split = media.in_band(inside, red);
  EXPECT_NE(split, media.in_band(inside, violet));
  EXPECT_EQ(split, media.in_band(inside, red));
  EXPECT_EQ(media.innermost(split), 5u);
  EXPECT_TRUE(media.contains(split, 3));
  EXPECT_FALSE(media.contains(split, 4));
  EXPECT_EQ(media.depth(split), 2u);
  const std::uint32_t outside = media.left(media.left(split, 3), 5);
  EXPECT_TRUE(media.is_outside(outside));
  EXPECT_NE(outside, MediumTable::kOutside);
  EXPECT_EQ(media.band(media.entered(outside, 3)).number, 6);
}

}  // namespace
}  // namespace firstlight::render
