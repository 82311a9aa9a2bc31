#include "priority/block_pool.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

namespace firstlight::priority {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;  // of x86-64 and of most ARM systems
constexpr std::size_t kChunkBytes = 16 * kHugePage;
constexpr std::size_t kBlocksOfChunk = kChunkBytes / BlockPool::kBlockBytes;
static_assert(kChunkBytes % BlockPool::kBlockBytes == 0);

}  // namespace

void BlockPool::FreeChunk::operator()(void* chunk) const { std::free(chunk); }

void BlockPool::add_chunk_locked() {
  Chunk chunk(std::aligned_alloc(kHugePage, kChunkBytes));
  if (chunk == nullptr) throw std::bad_alloc();
  // Only a wish; without huge pages every 4 KiB are a page fault of their own.
  madvise(chunk.get(), kChunkBytes, MADV_HUGEPAGE);
  // The list is built from the end, so that blocks, and with them fresh pages, are used in the order of addresses.
  auto* tasks = static_cast<render::RayTask*>(chunk.get()) + kBlocksOfChunk * kBlockSize;
  chunks_.push_back(std::move(chunk));
  for (std::size_t i = 0; i < kBlocksOfChunk; ++i) {
    tasks -= kBlockSize;
    free_ = &blocks_.emplace_back(Block{tasks, 0, free_});
  }
}

Block* BlockPool::acquire() {
  const std::lock_guard lock(mutex_);
  if (free_ == nullptr) add_chunk_locked();
  Block* const block = free_;
  free_ = block->next;
  block->next = nullptr;
  block->count = 0;
  peak_ = std::max(peak_, ++used_);
  return block;
}

void BlockPool::release(Block* block) {
  const std::lock_guard lock(mutex_);
  block->next = free_;
  free_ = block;
  --used_;
}

std::size_t BlockPool::peak_bytes() const {
  const std::lock_guard lock(mutex_);
  return peak_ * kBlockBytes;
}

}  // namespace firstlight::priority
