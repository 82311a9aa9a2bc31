#include "priority/ray_queue.h"

#include <algorithm>
#include <utility>

namespace firstlight::priority {

RayQueue::RayQueue(BlockPool& pool, int workers)
    : pool_(pool), workers_(workers), full_(static_cast<std::size_t>(workers), Lists{}), slots_{} {}

void RayQueue::add_full_locked(Slot slot, Block* block, std::size_t worker) {
  block->next = std::exchange(full_[worker][slot], block);
  ++slots_[slot].full;
}

Block* RayQueue::add_locked(Slot slot, Block* block, std::size_t worker) {
  const std::uint32_t size = pool_.block_size();
  if (block->count == size) {
    add_full_locked(slot, block, worker);
    return nullptr;
  }
  Block*& partial = slots_[slot].partial;
  if (partial == nullptr) {
    partial = block;
    return nullptr;
  }
  // Two half-empty blocks become one, so that flushing early costs no memory.
  Block* const into = partial;
  const std::uint32_t moved = std::min(size - into->count, block->count);
  std::copy_n(block->tasks + block->count - moved, moved, into->tasks + into->count);
  into->count += moved;
  block->count -= moved;
  if (into->count == size) {
    add_full_locked(slot, into, worker);
    partial = nullptr;
  }
  if (block->count == 0) return block;
  partial = block;
  return nullptr;
}

void RayQueue::push(std::span<const Filled> blocks, std::uint64_t version, std::size_t worker) {
  Block* emptied = nullptr;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [slot, block] : blocks) {
      block->next = nullptr;
      if (version < version_) {
        make_stale_locked(block);
      } else {
        if (Block* const left_over = add_locked(slot, block, worker); left_over != nullptr) {
          left_over->next = std::exchange(emptied, left_over);
        }
        used_.insert(slot);
      }
      if (idle() > 0) changed_.notify_one();
    }
    if (top() < used_.top()) top_.store(used_.top(), std::memory_order_relaxed);
  }
  while (emptied != nullptr) pool_.release(std::exchange(emptied, emptied->next));
}

std::size_t RayQueue::owner_locked(Slot slot, std::size_t worker) const {
  while (full_[worker][slot] == nullptr) worker = (worker + 1) % full_.size();
  return worker;
}

RayQueue::Popped RayQueue::pop_locked(std::size_t worker, int at_least, Among among, int most) {
  const int top = used_.top(among);
  if (top == kNoSlot || top < at_least || closed()) return {};
  const auto slot = static_cast<Slot>(top);
  InSlot& in_slot = slots_[slot];
  Block* block = nullptr;
  if (in_slot.full > 0) {
    Block*& list = full_[owner_locked(slot, worker)][slot];
    block = list;
    Block* last = block;
    int count = 1;
    for (; count < most && last->next != nullptr; ++count) last = last->next;
    list = std::exchange(last->next, nullptr);
    in_slot.full -= static_cast<std::uint32_t>(count);
  } else {
    block = std::exchange(in_slot.partial, nullptr);
  }
  if (in_slot.full == 0 && in_slot.partial == nullptr) {
    used_.erase(slot);
    top_.store(used_.top(), std::memory_order_relaxed);
  }
  return {block, slot};
}

RayQueue::Popped RayQueue::pop(std::size_t worker, int at_least, Among among, int most) {
  const std::lock_guard lock(mutex_);
  return pop_locked(worker, at_least, among, idle() > 0 ? 1 : most);
}

RayQueue::Popped RayQueue::wait_and_pop(std::size_t worker, const std::function<bool()>& refill) {
  std::unique_lock lock(mutex_);
  const auto something = [this] { return used_.top() != kNoSlot || stale_ != nullptr; };
  if (idle() + 1 == workers_ && !something() && !closed()) {
    // The last one to run dry: no worker holds an open block, so nothing can come any more, but by a refill. It is not
    // idle meanwhile: nobody may think that the picture is at rest.
    if (refill()) {
      ++refills_;
    } else {
      closed_.store(true, std::memory_order_relaxed);
    }
    changed_.notify_all();
  } else {
    idle_.fetch_add(1, std::memory_order_relaxed);
    changed_.wait(lock, [&, seen = refills_] { return closed() || something() || refills_ != seen; });
    idle_.fetch_sub(1, std::memory_order_relaxed);
  }
  return pop_locked(worker, 0, Among::all, 1);
}

void RayQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_.store(true, std::memory_order_relaxed);
  changed_.notify_all();
}

void RayQueue::make_stale_locked(Block* list) {
  if (list == nullptr) return;
  if (stale_ == nullptr && rekeying_now_ == 0) {
    rekey_begin_ = Clock::now();
    ++rekeying_.count;
  }
  while (list != nullptr) {
    Block* const next = list->next;
    list->next = stale_;
    stale_ = list;
    list = next;
  }
  has_stale_.store(true, std::memory_order_release);
}

void RayQueue::begin_rekey(std::uint64_t version) {
  const std::lock_guard lock(mutex_);
  if (version <= version_) return;
  version_ = version;
  for (int top = used_.top(); top != kNoSlot; top = used_.top()) {
    const auto slot = static_cast<Slot>(top);
    for (Lists& lists : full_) make_stale_locked(std::exchange(lists[slot], nullptr));
    slots_[slot].full = 0;
    make_stale_locked(std::exchange(slots_[slot].partial, nullptr));
    used_.erase(slot);
  }
  top_.store(kNoSlot, std::memory_order_relaxed);
  if (stale_ != nullptr) changed_.notify_all();
}

Block* RayQueue::pop_stale() {
  const std::lock_guard lock(mutex_);
  Block* const block = stale_;
  if (block == nullptr) return nullptr;
  stale_ = block->next;
  block->next = nullptr;
  ++rekeying_now_;
  if (stale_ == nullptr) has_stale_.store(false, std::memory_order_release);
  return block;
}

void RayQueue::rekeyed(std::uint32_t rays) {
  const std::lock_guard lock(mutex_);
  rekeying_.rays += rays;
  if (--rekeying_now_ > 0 || stale_ != nullptr) return;
  rekeying_.longest_s =
      std::max(rekeying_.longest_s, std::chrono::duration<double>(Clock::now() - rekey_begin_).count());
}

RayQueue::Rekeying RayQueue::rekeying() const {
  const std::lock_guard lock(mutex_);
  return rekeying_;
}

void RayQueue::count(std::int64_t change, std::int64_t highest) {
  // Below zero for a moment, when who took rays tells of it before the one who brought them.
  const std::int64_t with_new = waiting_.fetch_add(change, std::memory_order_relaxed) + highest;
  std::int64_t peak = peak_rays_.load(std::memory_order_relaxed);
  while (with_new > peak && !peak_rays_.compare_exchange_weak(peak, with_new, std::memory_order_relaxed)) {
  }
}

}  // namespace firstlight::priority
