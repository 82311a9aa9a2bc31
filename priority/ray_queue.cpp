#include "priority/ray_queue.h"

#include <algorithm>

namespace firstlight::priority {

RayQueue::RayQueue(BlockPool& pool, int workers) : pool_(pool), workers_(workers), lists_{} {}

void RayQueue::add_full(List& list, Block* block) {
  block->next = list.full;
  list.full = block;
}

void RayQueue::push(Slot slot, Block* block) {
  Block* emptied = nullptr;
  {
    const std::lock_guard lock(mutex_);
    List& list = lists_[slot];
    if (block->full()) {
      add_full(list, block);
    } else if (list.partial == nullptr) {
      list.partial = block;
    } else {
      // Two half-empty blocks become one, so that flushing early costs no memory.
      Block* const into = list.partial;
      const std::uint32_t moved = std::min(kBlockSize - into->count, block->count);
      std::copy_n(block->tasks + block->count - moved, moved, into->tasks + into->count);
      into->count += moved;
      block->count -= moved;
      if (into->full()) {
        add_full(list, into);
        list.partial = nullptr;
      }
      if (block->count > 0) {
        list.partial = block;
      } else {
        emptied = block;
      }
    }
    used_.insert(slot);
    top_.store(used_.top(), std::memory_order_relaxed);
    if (idle_.load(std::memory_order_relaxed) > 0) changed_.notify_one();
  }
  if (emptied != nullptr) pool_.release(emptied);
}

RayQueue::Popped RayQueue::pop_locked(int at_least) {
  const int top = used_.top();
  if (top == kNoSlot || top < at_least || closed_) return {};
  List& list = lists_[static_cast<Slot>(top)];
  Block* block = list.full;
  if (block != nullptr) {
    list.full = block->next;
    block->next = nullptr;
  } else {
    block = list.partial;
    list.partial = nullptr;
  }
  if (list.full == nullptr && list.partial == nullptr) {
    used_.erase(static_cast<Slot>(top));
    top_.store(used_.top(), std::memory_order_relaxed);
  }
  return {block, static_cast<Slot>(top)};
}

RayQueue::Popped RayQueue::pop(int at_least) {
  const std::lock_guard lock(mutex_);
  return pop_locked(at_least);
}

RayQueue::Popped RayQueue::wait_and_pop() {
  std::unique_lock lock(mutex_);
  if (idle_.fetch_add(1, std::memory_order_relaxed) + 1 == workers_ && used_.top() == kNoSlot) {
    // The last one to run dry: no worker holds an open block, so nothing can come any more.
    closed_ = true;
    changed_.notify_all();
  }
  changed_.wait(lock, [this] { return closed_ || used_.top() != kNoSlot; });
  idle_.fetch_sub(1, std::memory_order_relaxed);
  return pop_locked(0);
}

void RayQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

void RayQueue::count(std::uint64_t spawned, std::uint64_t taken) {
  const std::uint64_t with_new = waiting_.fetch_add(spawned, std::memory_order_relaxed) + spawned;
  std::uint64_t peak = peak_rays_.load(std::memory_order_relaxed);
  while (with_new > peak && !peak_rays_.compare_exchange_weak(peak, with_new, std::memory_order_relaxed)) {
  }
  waiting_.fetch_sub(taken, std::memory_order_relaxed);
}

}  // namespace firstlight::priority
