#include "render/math/shared.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace firstlight::render {
namespace {

struct Thing {
  int number = 7;
  std::vector<int> list = {};
};

TEST(Shared, IsTheInitialValueWhileNothingIsChanged) {
  const Shared<Thing> thing;
  EXPECT_TRUE(thing.is_initial());
  EXPECT_EQ(thing->number, 7);
  EXPECT_TRUE(thing.is_same(Shared<Thing>()));
}

TEST(Shared, CopiesAreOneUntilOneIsChanged) {
  Shared<Thing> first(Thing{.number = 1, .list = {1, 2}});
  Shared<Thing> second = first;
  EXPECT_TRUE(first.is_same(second));
  second.change().number = 2;
  EXPECT_FALSE(first.is_same(second));
  EXPECT_EQ(first->number, 1);
  EXPECT_EQ(second->number, 2);
  EXPECT_EQ(second->list, (std::vector<int>{1, 2}));
}

TEST(Shared, WhatNobodySharesIsChangedInPlace) {
  Shared<Thing> thing;
  Thing* before = &thing.change();
  before->list = {3};
  EXPECT_EQ(&thing.change(), before);
  EXPECT_EQ(thing->list, std::vector<int>{3});
  EXPECT_TRUE(Shared<Thing>().is_initial());
  EXPECT_TRUE(Shared<Thing>()->list.empty()) << "the initial value stays as it is";
}

struct Ending {
  int* ends = nullptr;
  ~Ending() {
    if (ends != nullptr) ++*ends;
  }
};

TEST(Shared, EndsWithItsLastCopyWhicheverThreadDropsIt) {
  int ends = 0;
  {
    std::vector<std::jthread> threads;
    Shared<Ending> all;
    all.change().ends = &ends;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([mine = all] {
        for (int turn = 0; turn < 10000; ++turn) Shared<Ending> another = mine;
      });
    }
    all = Shared<Ending>();
  }
  EXPECT_EQ(ends, 1);
}

}  // namespace
}  // namespace firstlight::render
