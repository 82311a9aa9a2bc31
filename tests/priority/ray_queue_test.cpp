#include "priority/ray_queue.h"

#include "priority/open_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <random>
#include <set>
#include <thread>
#include <vector>

namespace firstlight::priority {
namespace {

using render::RayKind;
using render::RayTask;

RayTask task_of(std::uint32_t sample) {
  RayTask task;
  task.origin = render::Vec3(0.0);
  task.set_weight(render::Rgb(1.0f), 1.0f);
  task.sample = sample;
  return task;
}

constexpr std::uint64_t kVersion = 1;

bool no_more() { return false; }

/// A queue for one worker, on the heap for its size.
struct Bench {
  BlockPool pool;
  std::unique_ptr<RayQueue> queue = std::make_unique<RayQueue>(pool, 1);

  void push(Slot slot, Block* block, std::uint64_t version) {
    queue->push(std::array{RayQueue::Filled{slot, block}}, version, 0);
  }
  Block* block(std::uint32_t count, std::uint32_t first_sample = 0) {
    Block* const out = pool.acquire();
    for (std::uint32_t i = 0; i < count; ++i) out->tasks[out->count++] = task_of(first_sample + i);
    return out;
  }
};

TEST(SlotSet, FindsTheLargestMember) {
  std::mt19937 random(7);
  SlotSet set;
  std::set<Slot> expected;
  EXPECT_EQ(set.top(), kNoSlot);
  for (int i = 0; i < 20000; ++i) {
    const Slot slot = static_cast<Slot>(random() % kSlots);
    if (random() % 2 == 0) {
      set.insert(slot);
      expected.insert(slot);
    } else {
      set.erase(slot);
      expected.erase(slot);
    }
    ASSERT_EQ(set.top(), expected.empty() ? kNoSlot : static_cast<int>(*expected.rbegin()));
  }
}

TEST(BlockPool, CountsWhatIsInUseAndItsPeak) {
  BlockPool pool;
  std::vector<Block*> blocks;
  for (int i = 0; i < 100; ++i) blocks.push_back(pool.acquire());
  EXPECT_EQ(pool.bytes(), 100 * pool.block_bytes());
  EXPECT_EQ(std::set<RayTask*>([&] {
              std::set<RayTask*> places;
              for (const Block* block : blocks) places.insert(block->tasks);
              return places;
            }())
                .size(),
            100u);
  for (Block* block : blocks) pool.release(block);
  EXPECT_EQ(pool.bytes(), 0u);
  for (int i = 0; i < 50; ++i) pool.acquire();
  EXPECT_EQ(pool.bytes(), 50 * pool.block_bytes());
  EXPECT_EQ(pool.peak_bytes(), 100 * pool.block_bytes());
}

TEST(BlockPool, KeepsItsBudget) {
  constexpr std::size_t kBudget = 1 << 20;
  BlockPool pool(kBudget);
  EXPECT_LT(pool.block_size(), BlockPool::kLargestBlock);
  std::vector<Block*> blocks;
  for (Block* block = pool.acquire(); block != nullptr; block = pool.acquire()) blocks.push_back(block);
  EXPECT_LE(pool.bytes(), kBudget);
  EXPECT_GT(pool.bytes(), kBudget / 10 * 9);
  pool.release(blocks.back());
  EXPECT_NE(pool.acquire(), nullptr);
}

TEST(BlockPool, GivesMemoryBackThatNobodyUses) {
  BlockPool pool;
  constexpr int kBlocks = 60000;  // of several chunks
  std::vector<Block*> blocks;
  for (int i = 0; i < kBlocks; ++i) blocks.push_back(pool.acquire());
  const std::size_t full = pool.reserved_bytes();
  for (Block* block : blocks) pool.release(block);
  EXPECT_LT(pool.reserved_bytes(), full / 4);
  EXPECT_GT(pool.reserved_bytes(), 0u) << "one chunk stays for the next rays";
}

TEST(BlockPool, GivesEmptyBlocks) {
  BlockPool pool;
  Block* const first = pool.acquire();
  first->count = 17;
  pool.release(first);
  EXPECT_EQ(pool.acquire()->count, 0u);
}

TEST(RayQueue, HighestSlotLeavesFirst) {
  Bench bench;
  for (const Slot slot : {3u, 200u, 17u, 8191u}) bench.push(slot, bench.block(slot % 50 + 1), kVersion);
  for (const Slot slot : {8191u, 200u, 17u, 3u}) {
    const auto popped = bench.queue->pop(0);
    ASSERT_NE(popped.block, nullptr);
    EXPECT_EQ(popped.slot, slot);
    EXPECT_EQ(popped.block->count, slot % 50 + 1);
  }
  EXPECT_EQ(bench.queue->pop(0).block, nullptr);
  EXPECT_EQ(bench.queue->top(), kNoSlot);
}

TEST(RayQueue, RadianceLeavesBeforeShadowsOfTheSameKeyAndAfterAHigherKey) {
  EXPECT_GT(slot_of(5, RayKind::reflection), slot_of(5, RayKind::shadow));
  EXPECT_EQ(slot_of(5, RayKind::reflection), slot_of(5, RayKind::primary));
  EXPECT_LT(slot_of(5, RayKind::reflection), slot_of(6, RayKind::shadow));
  EXPECT_EQ(key_of(slot_of(5, RayKind::shadow)), 5u);
  EXPECT_EQ(key_of(slot_of(5, RayKind::transmission)), 5u);
  EXPECT_LT(slot_of(kBuckets - 1, RayKind::primary), kSlots);
}

TEST(RayQueue, GivesNothingBelowWhatIsAskedFor) {
  Bench bench;
  bench.push(10, bench.block(5), kVersion);
  EXPECT_EQ(bench.queue->pop(0, 11).block, nullptr);
  EXPECT_NE(bench.queue->pop(0, 10).block, nullptr);
}

TEST(RayQueue, FullBlocksLeaveBeforeTheOthersOfTheirSlot) {
  Bench bench;
  bench.push(4, bench.block(10), kVersion);
  bench.push(4, bench.block(BlockPool::kLargestBlock), kVersion);
  EXPECT_EQ(bench.queue->pop(0).block->count, BlockPool::kLargestBlock);
  EXPECT_EQ(bench.queue->pop(0).block->count, 10u);
}

TEST(RayQueue, GivesSeveralFullBlocksOfOneSlotAtOnce) {
  Bench bench;
  std::vector<RayQueue::Filled> blocks;
  for (const Slot slot : {4u, 9u, 4u, 4u, 4u}) blocks.push_back({slot, bench.block(BlockPool::kLargestBlock)});
  blocks.push_back({4, bench.block(3)});
  bench.queue->push(blocks, kVersion, 0);
  for (const auto& [slot, length] : {std::pair(9u, 1), {4u, 3}, {4u, 1}, {4u, 1}}) {
    const auto popped = bench.queue->pop(0, 0, Among::all, 3);
    EXPECT_EQ(popped.slot, slot);
    int count = 0;
    for (const Block* block = popped.block; block != nullptr; block = block->next) ++count;
    EXPECT_EQ(count, length);
  }
  EXPECT_EQ(bench.queue->pop(0, 0, Among::all, 3).block, nullptr);
}

TEST(RayQueue, OfOneSlotAWorkersOwnBlocksLeaveFirst) {
  BlockPool pool;
  RayQueue queue(pool, 3);
  const auto full = [&](std::uint32_t sample) {
    Block* const block = pool.acquire();
    block->count = pool.block_size();
    std::fill_n(block->tasks, block->count, task_of(sample));
    return block;
  };
  queue.push(std::array{RayQueue::Filled{5, full(1)}, RayQueue::Filled{3, full(10)}}, kVersion, 1);
  queue.push(std::array{RayQueue::Filled{5, full(2)}, RayQueue::Filled{3, full(20)}}, kVersion, 2);
  EXPECT_EQ(queue.pop(2).block->tasks[0].sample, 2u);
  EXPECT_EQ(queue.pop(2).block->tasks[0].sample, 1u) << "the slot comes before the worker";
  EXPECT_EQ(queue.pop(1).block->tasks[0].sample, 10u);
  EXPECT_EQ(queue.pop(0).block->tasks[0].sample, 20u);
  EXPECT_EQ(queue.pop(0).block, nullptr);
}

TEST(RayQueue, JoinsHalfEmptyBlocksWithoutLosingARay) {
  Bench bench;
  constexpr std::uint32_t kPart = BlockPool::kLargestBlock * 2 / 3;  // two fill a block and leave some over
  for (std::uint32_t i = 0; i < 5; ++i) bench.push(9, bench.block(kPart, i * kPart), kVersion);
  EXPECT_EQ(bench.pool.bytes(), 4 * bench.pool.block_bytes()) << "five thirds of two blocks fit into four";
  std::vector<bool> seen(5 * kPart);
  for (auto popped = bench.queue->pop(0); popped.block != nullptr; popped = bench.queue->pop(0)) {
    for (const RayTask& task : popped.block->span()) {
      EXPECT_FALSE(seen[task.sample]);
      seen[task.sample] = true;
    }
    bench.pool.release(popped.block);
  }
  EXPECT_EQ(std::ranges::count(seen, true), 5 * kPart);
  EXPECT_EQ(bench.pool.bytes(), 0u);
}

TEST(RayQueue, ALoneWorkerThatFindsNothingIsDone) {
  Bench bench;
  bench.push(1, bench.block(1), kVersion);
  EXPECT_NE(bench.queue->wait_and_pop(0, no_more).block, nullptr);
  EXPECT_EQ(bench.queue->wait_and_pop(0, no_more).block, nullptr);
}

TEST(RayQueue, AWaitingWorkerGetsWhatAnotherPushesAndBothEnd) {
  BlockPool pool;
  const auto queue = std::make_unique<RayQueue>(pool, 2);
  std::uint32_t received = 0;
  std::jthread other([&] {
    for (auto popped = queue->wait_and_pop(0, no_more); popped.block != nullptr;
         popped = queue->wait_and_pop(0, no_more)) {
      received += popped.block->count;
      pool.release(popped.block);
    }
  });
  Block* const block = pool.acquire();
  block->count = 3;
  queue->push(std::array{RayQueue::Filled{7, block}}, kVersion, 0);
  std::uint32_t own = 0;
  for (auto popped = queue->wait_and_pop(0, no_more); popped.block != nullptr;
       popped = queue->wait_and_pop(0, no_more)) {
    own += popped.block->count;
  }
  other.join();
  EXPECT_EQ(received + own, 3u);
}

TEST(RayQueue, TheLastWorkerToRunDryMayFindMoreAndWakesTheOthers) {
  BlockPool pool;
  const auto queue = std::make_unique<RayQueue>(pool, 2);
  std::atomic<int> refills = 0;
  const auto refill = [&] { return ++refills <= 3; };
  const auto work = [&] {
    while (!queue->closed()) EXPECT_EQ(queue->wait_and_pop(0, refill).block, nullptr);
  };
  {
    std::jthread one(work);
    std::jthread other(work);
  }
  EXPECT_EQ(refills, 4);
}

TEST(RayQueue, AnotherOrderMakesAllThatWaitsStaleOnce) {
  Bench bench;
  bench.push(3, bench.block(5), 1);
  bench.push(900, bench.block(7), 1);
  bench.queue->begin_rekey(2);
  bench.queue->begin_rekey(2);
  EXPECT_EQ(bench.queue->top(), kNoSlot);
  std::uint32_t rays = 0;
  while (bench.queue->has_stale()) {
    Block* const block = bench.queue->pop_stale();
    ASSERT_NE(block, nullptr);
    const std::uint32_t count = block->count;
    rays += count;
    bench.push(40, block, 2);
    bench.queue->rekeyed(count);
  }
  EXPECT_EQ(rays, 12u);
  EXPECT_EQ(bench.queue->pop(0).slot, 40u);
  EXPECT_EQ(bench.queue->rekeying().count, 1u);
  EXPECT_EQ(bench.queue->rekeying().rays, 12u);
}

TEST(RayQueue, WhatComesInAnOlderOrderIsStaleAtOnce) {
  Bench bench;
  bench.queue->begin_rekey(5);
  bench.push(3, bench.block(5), 4);
  EXPECT_TRUE(bench.queue->has_stale());
  EXPECT_EQ(bench.queue->top(), kNoSlot);
}

TEST(RayQueue, ClosingWakesThoseWhoWait) {
  BlockPool pool;
  const auto queue = std::make_unique<RayQueue>(pool, 2);
  std::jthread other([&] { EXPECT_EQ(queue->wait_and_pop(0, no_more).block, nullptr); });
  queue->close();
}

TEST(RayQueue, CountsWaitingRaysAndTheirPeak) {
  Bench bench;
  bench.queue->count(100, 100);
  bench.queue->count(20, 50);
  bench.queue->count(-60, 0);
  EXPECT_EQ(bench.queue->waiting(), 60u);
  EXPECT_EQ(bench.queue->peak_rays(), 150u);
}

TEST(RayQueue, MayBeToldOfRaysThatWereTakenBeforeThoseThatCame) {
  Bench bench;
  bench.queue->count(-60, 0);
  EXPECT_EQ(bench.queue->waiting(), 0u);
  EXPECT_EQ(bench.queue->peak_rays(), 0u);
  bench.queue->count(100, 100);
  EXPECT_EQ(bench.queue->waiting(), 40u);
  EXPECT_EQ(bench.queue->peak_rays(), 40u);
}

TEST(OpenBlocks, KeepEveryRayUnderItsKey) {
  Bench bench;
  const auto open = std::make_unique<OpenBlocks>(bench.pool, *bench.queue, 0);
  std::mt19937 random(11);
  constexpr std::uint32_t kRays = 50000;
  std::vector<Key> keys;
  std::vector<RayTask> tasks;
  for (std::uint32_t i = 0; i < kRays; ++i) {
    RayTask task = task_of(i);
    task.kind = i % 3 == 0 ? RayKind::shadow : RayKind::reflection;
    tasks.push_back(task);
    keys.push_back(static_cast<Key>(random() % 20));
  }
  std::vector<RayTask> overflow;
  open->scatter(tasks, keys, overflow);
  EXPECT_TRUE(overflow.empty());
  EXPECT_NE(bench.queue->top(), kNoSlot) << "full blocks are handed on";
  open->send_full();
  EXPECT_EQ(open->top_of_full(), kNoSlot);
  EXPECT_EQ(open->top(), static_cast<int>(slot_of(19, RayKind::reflection)));
  open->flush();
  EXPECT_EQ(open->top(), kNoSlot);
  std::vector<bool> seen(kRays);
  Slot last = kSlots;
  for (auto popped = bench.queue->pop(0); popped.block != nullptr; popped = bench.queue->pop(0)) {
    EXPECT_LE(popped.slot, last);
    last = popped.slot;
    for (const RayTask& task : popped.block->span()) {
      EXPECT_EQ(popped.slot, slot_of(keys[task.sample], task.kind));
      EXPECT_FALSE(seen[task.sample]);
      seen[task.sample] = true;
    }
  }
  EXPECT_EQ(std::ranges::count(seen, true), kRays);
}

}  // namespace
}  // namespace firstlight::priority
