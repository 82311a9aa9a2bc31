#pragma once

#include "render/trace/ray_task.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace firstlight::priority {

/// Room for some waiting rays of one key. Belongs to its pool.
struct Block {
  render::RayTask* tasks = nullptr;
  std::uint32_t count = 0;
  std::uint32_t chunk = 0;  ///< of its pool
  Block* next = nullptr;    ///< in a list of blocks

  std::span<const render::RayTask> span() const { return {tasks, count}; }
};

/// Where blocks come from and go back to.
///
/// Memory   taken from the system in chunks of huge pages, which go back when all their blocks are free; one free chunk
///          is kept, because the first touch of a fresh page costs about as much as tracing the rays in it. What is
///          taken never exceeds the budget.
/// Threads  all members may be called from any thread; one lock a block.
class BlockPool {
 public:
  /// Few enough that a block is a fine grain of order, enough that threads seldom meet at a lock.
  static constexpr std::uint32_t kLargestBlock = 64;
  static constexpr std::uint32_t kSmallestBlock = 16;

  /// `budget`: bytes, 0: no limit. `block_size`: rays in a full block, 0: as many as suit the budget.
  explicit BlockPool(std::size_t budget = 0, std::uint32_t block_size = 0);
  ~BlockPool();
  BlockPool(const BlockPool&) = delete;
  BlockPool& operator=(const BlockPool&) = delete;

  std::uint32_t block_size() const { return block_size_; }
  /// Bytes of one block, with what the pool keeps of it.
  std::size_t block_bytes() const { return block_size_ * sizeof(render::RayTask) + sizeof(Block); }

  /// An empty block; null when the budget is used up. Throws std::bad_alloc when the machine has no memory left.
  Block* acquire();
  /// Takes back a block that acquire() gave.
  void release(Block* block);

  /// Bytes of the blocks in use.
  std::size_t bytes() const { return used_.load(std::memory_order_relaxed) * block_bytes(); }
  /// The most that was in use at any time.
  std::size_t peak_bytes() const;
  /// Taken from the system.
  std::size_t reserved_bytes() const;
  std::size_t budget() const { return budget_; }

 private:
  struct Chunk {
    void* memory = nullptr;  ///< null: given back
    std::size_t blocks = 0;
    std::size_t used = 0;
    Block* free = nullptr;
    std::unique_ptr<Block[]> headers;
  };
  bool add_chunk_locked();

  const std::size_t budget_;
  const std::uint32_t block_size_;
  std::size_t most_blocks_;  // within the budget
  mutable std::mutex mutex_;
  std::vector<Chunk> chunks_;
  std::uint32_t lowest_free_ = 0;      // no chunk before it has a free block
  std::uint32_t free_chunks_ = 0;      // with memory, and no block in use
  std::size_t reserved_ = 0;           // blocks in chunks with memory
  std::atomic<std::size_t> used_ = 0;  // changed under the lock only
  std::size_t peak_ = 0;
};

}  // namespace firstlight::priority
