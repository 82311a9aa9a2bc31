#include "priority/open_blocks.h"

#include <utility>

namespace firstlight::priority {

void OpenBlocks::scatter(std::span<const render::RayTask> tasks, std::span<const Key> keys) {
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Slot slot = slot_of(keys[i], tasks[i].kind);
    Block* block = open_[slot];
    if (block == nullptr) {
      block = pool_.acquire();
      open_[slot] = block;
      used_.insert(slot);
    }
    block->tasks[block->count++] = tasks[i];
    if (block->full()) queue_.push(slot, take(slot));
  }
}

Block* OpenBlocks::take(Slot slot) {
  used_.erase(slot);
  return std::exchange(open_[slot], nullptr);
}

void OpenBlocks::flush() {
  for (int slot = top(); slot != kNoSlot; slot = top()) {
    queue_.push(static_cast<Slot>(slot), take(static_cast<Slot>(slot)));
  }
}

}  // namespace firstlight::priority
