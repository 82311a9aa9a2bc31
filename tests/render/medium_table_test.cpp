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

}  // namespace
}  // namespace firstlight::render
