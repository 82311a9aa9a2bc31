#include "priority/open_blocks.h"

#include <algorithm>
#include <utility>

namespace firstlight::priority {

// With a small budget none: what one worker keeps, the others cannot use.
OpenBlocks::OpenBlocks(BlockPool& pool, RayQueue& queue, std::size_t worker)
    : pool_(pool),
      queue_(queue),
      worker_(worker),
      most_spare_(pool.budget() == 0 ? kMostSpare : std::min(kMostSpare, pool.budget() / pool.block_bytes() / 4096)),
      open_{} {}

OpenBlocks::~OpenBlocks() {
  while (spare_count_ > 0) pool_.release(spare_[--spare_count_]);
}

Block* OpenBlocks::acquire() {
  if (spare_count_ == 0) return pool_.acquire();
  Block* const block = spare_[--spare_count_];
  block->count = 0;
  block->next = nullptr;
  return block;
}

void OpenBlocks::release(Block* block) {
  if (spare_count_ < most_spare_) {
    spare_[spare_count_++] = block;
  } else {
    pool_.release(block);
  }
}

void OpenBlocks::scatter(std::span<const render::RayTask> tasks, std::span<const Key> keys,
                         std::vector<render::RayTask>& overflow) {
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Slot slot = slot_of(keys[i], tasks[i].kind);
    Block* block = open_[slot];
    if (block == nullptr) {
      block = acquire();
      if (block == nullptr) {
        overflow.push_back(tasks[i]);
        continue;
      }
      open_[slot] = block;
      used_.insert(slot);
    }
    block->tasks[block->count++] = tasks[i];
    if (block->count == pool_.block_size()) {
      full_[full_count_++] = {slot, take(slot)};
      top_of_full_ = std::max(top_of_full_, static_cast<int>(slot));
      if (full_count_ == kMostFull) send_full();
    } else {
      __builtin_prefetch(&block->tasks[block->count], 1);  // the next of this key comes when much else has been written
    }
  }
}

Block* OpenBlocks::take(Slot slot) {
  used_.erase(slot);
  return std::exchange(open_[slot], nullptr);
}

void OpenBlocks::send_full() {
  if (full_count_ == 0) return;
  queue_.push(std::span(full_).first(full_count_), version_, worker_);
  full_count_ = 0;
  top_of_full_ = kNoSlot;
}

void OpenBlocks::flush() {
  for (int slot = top(); slot != kNoSlot; slot = top()) {
    full_[full_count_++] = {static_cast<Slot>(slot), take(static_cast<Slot>(slot))};
    if (full_count_ == kMostFull) send_full();
  }
  send_full();
}

}  // namespace firstlight::priority
