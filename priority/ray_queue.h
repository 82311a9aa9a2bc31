#pragma once

#include "priority/block_pool.h"
#include "priority/slot.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace firstlight::priority {

/// Rays that have been spawned but not yet traced, in blocks of equal priority.
///
/// Key      integer in [0, kBuckets); the largest leaves first, equal keys are interchangeable.
///          [Yagel & Meeker 1997, section 4]
/// Cost     push and pop O(1) a block, whatever waits.
/// Memory   blocks come from `pool` and go back to it. At most one block of a slot is not full.
/// Threads  push and pop from any worker; one lock a block, none a ray.
class RayQueue {
 public:
  /// `workers` threads will wait for work here.
  RayQueue(BlockPool& pool, int workers);

  /// Takes `block`, filled by one worker with tasks of one `slot`.
  void push(Slot slot, Block* block);

  struct Popped {
    Block* block = nullptr;  ///< null: nothing waits
    Slot slot = 0;
  };
  /// The fullest block of the highest slot, if that is `at_least` or more.
  Popped pop(int at_least = 0);
  /// As pop(), but waits while other workers may still push. Null: all have run dry, or the queue was closed.
  Popped wait_and_pop();
  /// Wakes all who wait; nothing more comes out.
  void close();

  /// Highest slot, kNoSlot when nothing waits here; may be out of date.
  int top() const { return top_.load(std::memory_order_relaxed); }
  /// Whether a worker waits for blocks and finds none.
  bool starving() const { return idle_.load(std::memory_order_relaxed) > 0 && top() == kNoSlot; }

  // Rays waiting here and in the workers' open blocks are counted by the workers, once a batch.
  void count(std::uint64_t spawned, std::uint64_t taken);
  std::uint64_t waiting() const { return waiting_.load(std::memory_order_relaxed); }
  std::uint64_t peak_rays() const { return peak_rays_.load(std::memory_order_relaxed); }

 private:
  struct List {
    Block* full = nullptr;
    Block* partial = nullptr;  ///< neither full nor empty
  };
  Popped pop_locked(int at_least);
  void add_full(List& list, Block* block);

  BlockPool& pool_;
  const int workers_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::array<List, kSlots> lists_;
  SlotSet used_;
  bool closed_ = false;
  std::atomic<int> top_ = kNoSlot;  // changed under the lock only, as is idle_
  std::atomic<int> idle_ = 0;
  std::atomic<std::uint64_t> waiting_ = 0;
  std::atomic<std::uint64_t> peak_rays_ = 0;
};

}  // namespace firstlight::priority
