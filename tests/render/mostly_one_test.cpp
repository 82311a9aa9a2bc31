#include "render/math/mostly_one.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace firstlight::render {
namespace {

std::vector<std::string> items_of(const MostlyOne<std::string>& list) { return {list.begin(), list.end()}; }

TEST(MostlyOne, BeginsEmpty) {
  const MostlyOne<std::string> list;
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(list.begin(), list.end());
}

TEST(MostlyOne, KeepsItsItemsInOrderHoweverManyThereAre) {
  MostlyOne<std::string> list;
  std::vector<std::string> expected;
  for (const char* item : {"a", "b", "c", "d"}) {
    list.push_back(item);
    expected.push_back(item);
    EXPECT_EQ(items_of(list), expected);
    EXPECT_EQ(items_of(MostlyOne<std::string>(expected)), expected);
    EXPECT_EQ(list.front(), "a");
    EXPECT_EQ(list[expected.size() - 1], item);
  }
}

TEST(MostlyOne, OneItemLiesInTheListItself) {
  MostlyOne<int> list(std::vector<int>{7});
  const char* const at = reinterpret_cast<const char*>(list.begin());
  const char* const itself = reinterpret_cast<const char*>(&list);
  EXPECT_TRUE(at >= itself && at < itself + sizeof(list));
  EXPECT_EQ(list.front(), 7);
}

TEST(MostlyOne, CopiesDoNotShare) {
  MostlyOne<std::string> list(std::vector<std::string>{"a"});
  const MostlyOne<std::string> before = list;
  list.front() = "b";
  list.push_back("c");
  EXPECT_EQ(items_of(before), std::vector<std::string>{"a"});
  EXPECT_EQ(items_of(list), (std::vector<std::string>{"b", "c"}));
}

}  // namespace
}  // namespace firstlight::render
