#pragma once

#include "priority/block_pool.h"
#include "priority/slot.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <vector>

namespace firstlight::priority {

/// Rays that have been spawned but not yet traced, in blocks of equal priority.
///
/// Key      integer in [0, kBuckets); the largest leaves first, equal keys are interchangeable.
///          [Yagel & Meeker 1997, section 4]
///          Blocks that a worker has filled itself are the first of a slot that it gets: what their rays need is in its
///          caches.
/// Order    of a version: when the order changes, all that waits becomes stale, and the workers take it out, give it new
///          keys and push it again before they trace on.
/// Cost     push and pop O(1) a block, whatever waits.
/// Memory   blocks come from `pool` and go back to it. At most one block of a slot is not full.
/// Threads  push and pop from any worker; one lock for some blocks, none a ray.
class RayQueue {
 public:
  /// `workers` threads will wait for work here.
  RayQueue(BlockPool& pool, int workers);

  /// A block with tasks of one slot.
  struct Filled {
    Slot slot = 0;
    Block* block = nullptr;
  };
  /// Takes blocks that `worker` has filled by the order `version`.
  void push(std::span<const Filled> blocks, std::uint64_t version, std::size_t worker);

  struct Popped {
    Block* block = nullptr;  ///< the first of a list; null: nothing waits
    Slot slot = 0;
  };
  /// For `worker`, full blocks of the highest slot, or one that is not full, if the slot is `at_least` or more. Up to
  /// `most` of them; one if others wait.
  Popped pop(std::size_t worker, int at_least = 0, Among among = Among::all, int most = 1);
  /// As pop(), but waits while other workers may still push. When all have run dry, the last of them calls `refill`,
  /// while the others rest: true when there is something to do again. Null: look around for work of another kind, or
  /// closed().
  Popped wait_and_pop(std::size_t worker, const std::function<bool()>& refill);
  /// Wakes all who wait; nothing more comes out.
  void close();
  bool closed() const { return closed_.load(std::memory_order_relaxed); }

  /// Makes all that waits stale, unless the queue has seen the version already.
  void begin_rekey(std::uint64_t version);
  bool has_stale() const { return has_stale_.load(std::memory_order_acquire); }
  /// A block to be given new keys; null when there is none. Each is followed by one rekeyed().
  Block* pop_stale();
  /// The rays of a stale block have been pushed again.
  void rekeyed(std::uint32_t rays);

  struct Rekeying {
    std::uint64_t count = 0;  ///< how often the order changed with rays waiting
    std::uint64_t rays = 0;   ///< given a new key
    double longest_s = 0.0;   ///< until all of the waiting had theirs
  };
  Rekeying rekeying() const;

  /// Highest slot, kNoSlot when nothing waits here; may be out of date.
  int top() const { return top_.load(std::memory_order_relaxed); }
  /// Whether a worker waits for blocks and finds none.
  bool starving() const { return idle() > 0 && top() == kNoSlot; }
  /// Workers that wait here.
  int idle() const { return idle_.load(std::memory_order_relaxed); }

  // Rays waiting here and in the workers' open blocks are counted by the workers, once in a few batches.
  /// Their number has changed by `change`, and was higher by `highest` in between.
  void count(std::int64_t change, std::int64_t highest);
  std::uint64_t waiting() const {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, waiting_.load(std::memory_order_relaxed)));
  }
  std::uint64_t peak_rays() const { return static_cast<std::uint64_t>(peak_rays_.load(std::memory_order_relaxed)); }

 private:
  using Clock = std::chrono::steady_clock;
  using Lists = std::array<Block*, kSlots>;
  struct InSlot {
    std::uint32_t full = 0;    ///< blocks, of all workers
    Block* partial = nullptr;  ///< neither full nor empty
  };
  Popped pop_locked(std::size_t worker, int at_least, Among among, int most);
  /// The worker whose blocks of the slot leave, `worker` itself if it has any. Pre: somebody has a full one.
  std::size_t owner_locked(Slot slot, std::size_t worker) const;
  void add_full_locked(Slot slot, Block* block, std::size_t worker);
  /// Returns a block that is left over, to be released; or null.
  Block* add_locked(Slot slot, Block* block, std::size_t worker);
  void make_stale_locked(Block* list);

  BlockPool& pool_;
  const int workers_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Lists> full_;  // of each worker
  std::array<InSlot, kSlots> slots_;
  SlotSet used_;
  std::uint64_t version_ = 0;
  Block* stale_ = nullptr;
  int rekeying_now_ = 0;  // stale blocks taken out and not yet pushed again
  Clock::time_point rekey_begin_;
  Rekeying rekeying_;
  std::uint64_t refills_ = 0;
  // Looked at all the time and seldom changed, so apart from what is changed all the time.
  alignas(64) std::atomic<bool> has_stale_ = false;
  std::atomic<bool> closed_ = false;  // changed under the lock only, as are the next
  std::atomic<int> top_ = kNoSlot;
  std::atomic<int> idle_ = 0;
  alignas(64) std::atomic<std::int64_t> waiting_ = 0;
  std::atomic<std::int64_t> peak_rays_ = 0;
};

}  // namespace firstlight::priority
