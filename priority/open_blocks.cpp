#include "priority/open_blocks.h"

#include <utility>

namespace firstlight::priority {

void OpenBlocks::scatter(std::span<const render::RayTask> tasks, std::span<const Key> keys,
                         std::vector<render::RayTask>& overflow) {
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Slot slot = slot_of(keys[i], tasks[i].kind);
    Block* block = open_[slot];
    if (block == nullptr) {
      block = pool_.acquire();
      if (block == nullptr) {
        overflow.push_back(tasks[i]);
        continue;
      }
      open_[slot] = block;
      used_.insert(slot);
    }
    block->tasks[block->count++] = tasks[i];
    if (block->count == pool_.block_size()) queue_.push(slot, take(slot), version_);
  }
}

Block* OpenBlocks::take(Slot slot) {
  used_.erase(slot);
  return std::exchange(open_[slot], nullptr);
}

void OpenBlocks::flush() {
  for (int slot = top(); slot != kNoSlot; slot = top()) {
    queue_.push(static_cast<Slot>(slot), take(static_cast<Slot>(slot)), version_);
  }
}

}  // namespace firstlight::priority
