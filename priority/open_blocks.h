#pragma once

#include "priority/block_pool.h"
#include "priority/ray_queue.h"
#include "priority/slot.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::priority {

/// One worker's blocks under construction, one a slot; full ones go to the shared queue, several at once.
///
/// Cost     a 56-byte copy a ray; a lock for some blocks.
/// Threads  One a thread.
class OpenBlocks {
 public:
  /// `worker`: its number.
  OpenBlocks(BlockPool& pool, RayQueue& queue, std::size_t worker);
  ~OpenBlocks();
  OpenBlocks(const OpenBlocks&) = delete;
  OpenBlocks& operator=(const OpenBlocks&) = delete;

  /// Copies each task to the block of its key. Tasks for which the pool has no block left are appended to `overflow`.
  /// Pre: equal sizes, keys below kBuckets.
  void scatter(std::span<const render::RayTask> tasks, std::span<const Key> keys,
               std::vector<render::RayTask>& overflow);
  /// The highest slot with an open block, kNoSlot when there is none.
  int top(Among among = Among::all) const { return used_.top(among); }
  /// Removes and returns the open block of `slot`. Pre: there is one.
  Block* take(Slot slot);
  /// Takes back a block that take() or the queue gave. A few are kept for scatter(), because they are still in this
  /// processor's cache; the others go to the pool.
  void release(Block* block);
  /// The highest slot of the full blocks that the queue has not got yet; kNoSlot when there is none.
  int top_of_full() const { return top_of_full_; }
  /// Gives the full blocks to the queue.
  void send_full();
  /// Gives all blocks to the queue.
  void flush();
  /// The version of the order that the next tasks have their keys of. Gives all blocks to the queue.
  void set_version(std::uint64_t version) {
    flush();
    version_ = version;
  }

 private:
  static constexpr std::size_t kMostSpare = 32;
  static constexpr std::size_t kMostFull = 8;

  Block* acquire();

  BlockPool& pool_;
  RayQueue& queue_;
  const std::size_t worker_;
  const std::size_t most_spare_;
  std::size_t spare_count_ = 0;
  std::array<Block*, kMostSpare> spare_;
  std::size_t full_count_ = 0;
  std::array<RayQueue::Filled, kMostFull> full_;
  int top_of_full_ = kNoSlot;
  std::array<Block*, kSlots> open_;
  SlotSet used_;
  std::uint64_t version_ = 0;
};

}  // namespace firstlight::priority
