#include "priority/block_pool.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

namespace firstlight::priority {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{2} << 20;  // a huge page of x86-64 and of most ARM systems
constexpr std::size_t kSmallPage = 4096;
constexpr std::size_t kBlocksOfChunk = kChunkBytes / BlockPool::kBlockBytes;
/// Free blocks below which the next chunk is fetched.
constexpr std::size_t kReserve = 2 * kBlocksOfChunk;
static_assert(kChunkBytes % BlockPool::kBlockBytes == 0);

}  // namespace

void BlockPool::FreeChunk::operator()(void* chunk) const { std::free(chunk); }

BlockPool::BlockPool() : provider_([this](const std::stop_token& stop) { stay_ahead(stop); }) {}

BlockPool::Chunk BlockPool::make_chunk() {
  Chunk chunk(std::aligned_alloc(kChunkBytes, kChunkBytes));
  if (chunk == nullptr) throw std::bad_alloc();
  // Only a wish; without huge pages every 4 KiB are a page fault of their own.
  madvise(chunk.get(), kChunkBytes, MADV_HUGEPAGE);
  return chunk;
}

void BlockPool::add_locked(Chunk chunk) {
  auto* tasks = static_cast<render::RayTask*>(chunk.get());
  chunks_.push_back(std::move(chunk));
  for (std::size_t i = 0; i < kBlocksOfChunk; ++i, tasks += kBlockSize) {
    free_ = &blocks_.emplace_back(Block{tasks, 0, free_});
  }
}

void BlockPool::stay_ahead(std::stop_token stop) {
  const auto is_low = [this] { return used_ > 0 && blocks_.size() - used_ < kReserve; };
  try {
    std::unique_lock lock(mutex_);
    while (running_low_.wait(lock, stop, is_low) && !stop.stop_requested()) {
      lock.unlock();
      Chunk chunk = make_chunk();
      auto* const bytes = static_cast<volatile char*>(chunk.get());
      for (std::size_t i = 0; i < kChunkBytes; i += kSmallPage) bytes[i] = 0;
      lock.lock();
      add_locked(std::move(chunk));
    }
  } catch (const std::bad_alloc&) {
    // Whoever needs the memory next finds out for itself, and says so.
  }
}

Block* BlockPool::acquire() {
  const std::lock_guard lock(mutex_);
  if (free_ == nullptr) add_locked(make_chunk());
  Block* const block = free_;
  free_ = block->next;
  block->next = nullptr;
  block->count = 0;
  peak_ = std::max(peak_, ++used_);
  if (blocks_.size() - used_ == kReserve - 1) running_low_.notify_one();
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
