#include "priority/block_pool.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace firstlight::priority {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{2} << 20;  // a huge page of x86-64 and of most ARM systems
static_assert(kChunkBytes % BlockPool::kBlockBytes == 0);

}  // namespace

void BlockPool::FreeChunk::operator()(void* chunk) const { std::free(chunk); }

void BlockPool::add_chunk() {
  void* const memory = std::aligned_alloc(kChunkBytes, kChunkBytes);
  if (memory == nullptr) throw std::bad_alloc();
  chunks_.push_back(std::unique_ptr<void, FreeChunk>(memory));
  // Only a wish: without huge pages the first use of every 4 KiB costs a page fault, up to 30 % of the whole time.
  madvise(memory, kChunkBytes, MADV_HUGEPAGE);
  auto* tasks = static_cast<render::RayTask*>(memory);
  for (std::size_t i = 0; i < kChunkBytes / kBlockBytes; ++i, tasks += kBlockSize) {
    free_ = &blocks_.emplace_back(Block{tasks, 0, free_});
  }
}

Block* BlockPool::acquire() {
  const std::lock_guard lock(mutex_);
  if (free_ == nullptr) add_chunk();
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
