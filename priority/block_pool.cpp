#include "priority/block_pool.h"

#include <sys/mman.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <new>

namespace firstlight::priority {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;  // of x86-64 and of most ARM systems
constexpr std::size_t kChunkBytes = 16 * kHugePage;

// With a small budget a block is a small part of it: most blocks are not full.
std::uint32_t block_size_for(std::size_t budget) {
  constexpr std::size_t kBlocks = 2048;
  if (budget == 0) return BlockPool::kLargestBlock;
  const std::size_t size = std::bit_floor(std::max<std::size_t>(1, budget / sizeof(render::RayTask) / kBlocks));
  return static_cast<std::uint32_t>(std::clamp<std::size_t>(size, BlockPool::kSmallestBlock, BlockPool::kLargestBlock));
}

}  // namespace

BlockPool::BlockPool(std::size_t budget, std::uint32_t block_size)
    : budget_(budget),
      block_size_(block_size != 0 ? block_size : block_size_for(budget)),
      most_blocks_(budget != 0 ? budget / block_bytes() : std::numeric_limits<std::size_t>::max()) {}

BlockPool::~BlockPool() {
  for (const Chunk& chunk : chunks_) std::free(chunk.memory);
}

bool BlockPool::add_chunk_locked() {
  const std::size_t tasks_bytes = block_size_ * sizeof(render::RayTask);
  const std::size_t blocks = std::min(std::max<std::size_t>(1, kChunkBytes / tasks_bytes), most_blocks_ - reserved_);
  if (blocks == 0) return false;
  const std::size_t bytes = blocks * tasks_bytes;
  const std::size_t alignment = bytes >= kHugePage ? kHugePage : alignof(std::max_align_t) * 4;
  void* const memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  // Only a wish; without huge pages every 4 KiB are a page fault of their own.
  if (bytes >= kHugePage) madvise(memory, bytes, MADV_HUGEPAGE);

  auto chunk = std::ranges::find(chunks_, nullptr, &Chunk::memory);
  if (chunk == chunks_.end()) chunk = chunks_.insert(chunks_.end(), Chunk());
  chunk->memory = memory;
  chunk->blocks = blocks;
  chunk->used = 0;
  chunk->headers = std::make_unique<Block[]>(blocks);
  chunk->free = nullptr;
  // The list is built from the end, so that blocks, and with them fresh pages, are used in the order of addresses.
  for (std::size_t i = blocks; i-- > 0;) {
    Block& block = chunk->headers[i];
    block.tasks = static_cast<render::RayTask*>(memory) + i * block_size_;
    block.chunk = static_cast<std::uint32_t>(chunk - chunks_.begin());
    block.next = chunk->free;
    chunk->free = &block;
  }
  reserved_ += blocks;
  ++free_chunks_;
  lowest_free_ = std::min(lowest_free_, static_cast<std::uint32_t>(chunk - chunks_.begin()));
  return true;
}

Block* BlockPool::acquire() {
  const std::lock_guard lock(mutex_);
  while (lowest_free_ < chunks_.size() && chunks_[lowest_free_].free == nullptr) ++lowest_free_;
  if (lowest_free_ == chunks_.size() && !add_chunk_locked()) return nullptr;
  Chunk& chunk = chunks_[lowest_free_];
  Block* const block = chunk.free;
  chunk.free = block->next;
  if (chunk.used++ == 0) --free_chunks_;
  block->next = nullptr;
  block->count = 0;
  peak_ = std::max(peak_, ++used_);
  return block;
}

void BlockPool::release(Block* block) {
  const std::lock_guard lock(mutex_);
  Chunk& chunk = chunks_[block->chunk];
  block->next = chunk.free;
  chunk.free = block;
  lowest_free_ = std::min(lowest_free_, block->chunk);
  --used_;
  if (--chunk.used > 0 || ++free_chunks_ == 1) return;
  std::free(chunk.memory);
  reserved_ -= chunk.blocks;
  chunk = Chunk();
  --free_chunks_;
}

std::size_t BlockPool::peak_bytes() const {
  const std::lock_guard lock(mutex_);
  return peak_ * block_bytes();
}

std::size_t BlockPool::reserved_bytes() const {
  const std::lock_guard lock(mutex_);
  return reserved_ * block_bytes();
}

}  // namespace firstlight::priority
