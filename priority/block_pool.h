#pragma once

#include "render/trace/ray_task.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace firstlight::priority {

/// Tasks in a full block: few enough that a block is a fine grain of order, enough that threads seldom meet at a lock.
constexpr std::uint32_t kBlockSize = 1024;

/// Room for up to kBlockSize waiting rays of one key. Belongs to its pool.
struct Block {
  render::RayTask* tasks = nullptr;
  std::uint32_t count = 0;
  Block* next = nullptr;  ///< in a list of blocks

  bool full() const { return count == kBlockSize; }
  std::span<const render::RayTask> span() const { return {tasks, count}; }
};

/// Where blocks come from and go back to.
///
/// Memory   taken from the system in large chunks of huge pages, kept until the pool ends: the first touch of a fresh
///          page costs about as much as tracing the rays in it.
/// Threads  all members may be called from any thread; one lock a block.
class BlockPool {
 public:
  /// 64 bytes a task: 64 KiB.
  static constexpr std::size_t kBlockBytes = kBlockSize * sizeof(render::RayTask);

  BlockPool() = default;
  BlockPool(const BlockPool&) = delete;
  BlockPool& operator=(const BlockPool&) = delete;

  /// An empty block. Throws std::bad_alloc when the machine has no memory left.
  Block* acquire();
  /// Takes back a block that acquire() gave.
  void release(Block* block);

  /// Of blocks in use.
  std::size_t bytes() const { return used_.load(std::memory_order_relaxed) * kBlockBytes; }
  /// The most that was in use at any time.
  std::size_t peak_bytes() const;

 private:
  struct FreeChunk {
    void operator()(void* chunk) const;
  };
  using Chunk = std::unique_ptr<void, FreeChunk>;
  void add_chunk_locked();

  mutable std::mutex mutex_;
  std::vector<Chunk> chunks_;
  std::deque<Block> blocks_;
  Block* free_ = nullptr;
  std::atomic<std::size_t> used_ = 0;  // changed under the lock only
  std::size_t peak_ = 0;
};

}  // namespace firstlight::priority
