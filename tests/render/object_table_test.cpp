#include "render/scene/object_table.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace firstlight::render {
namespace {

using Names = std::vector<std::string>;

TEST(ObjectTable, GivesEqualSurfacesOneNumberAndOthersAnother) {
  ObjectTable table;
  const Names leg{"Chair", "Leg"};
  const ObjectTable::Names way = table.within(0, leg);
  const std::uint32_t number = table.group(way, "sphere", SurfaceKind::plain, 1);
  EXPECT_EQ(table.group(table.within(0, leg), "sphere", SurfaceKind::plain, 1), number);
  EXPECT_NE(table.group(table.within(0, Names{"Leg"}), "sphere", SurfaceKind::plain, 1), number);
  EXPECT_NE(table.group(way, "box", SurfaceKind::plain, 1), number);
  EXPECT_NE(table.group(way, "sphere", SurfaceKind::mirror, 1), number);
  EXPECT_NE(table.group(way, "sphere", SurfaceKind::plain, 2), number);
  EXPECT_EQ(table.group(way, "sphere", SurfaceKind::plain, 3), table.group(way, "sphere", SurfaceKind::plain, 2));
}

TEST(ObjectTable, DescribesItsGroups) {
  ObjectTable table;
  const ObjectTable::Names outer = table.within(0, Names{"Room", "Chair"});
  const std::uint32_t number = table.group(table.within(outer, Names{"Leg"}), "cylinder", SurfaceKind::clear, 5);
  const std::vector<ObjectGroup> groups = table.take();
  EXPECT_EQ(groups.at(number).names, (Names{"Room", "Chair", "Leg"}));
  EXPECT_EQ(groups.at(number).shape, "cylinder");
  EXPECT_EQ(groups.at(number).surface, SurfaceKind::clear);
  EXPECT_EQ(groups.at(number).complexity, 3);
}

TEST(ObjectTable, WhatIsTooManySharesTheLastNumber) {
  ObjectTable table;
  for (std::uint32_t i = 0; i + 1 < kMostObjectGroups; ++i) {
    ASSERT_EQ(table.group(table.within(0, Names{std::to_string(i)}), "sphere", SurfaceKind::plain, 1), i);
  }
  for (const char* name : {"A", "B"}) {
    EXPECT_EQ(table.group(table.within(0, Names{name}), "sphere", SurfaceKind::plain, 1), kMostObjectGroups - 1);
  }
  EXPECT_EQ(table.group(table.within(0, Names{"7"}), "sphere", SurfaceKind::plain, 1), 7u);
  EXPECT_TRUE(table.take().back().names.empty());
}

}  // namespace
}  // namespace firstlight::render
