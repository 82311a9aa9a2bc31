#include "priority/worker.h"

namespace firstlight::priority {

Worker::Worker(Frame& frame, render::Stepper& stepper, BlockPool& pool, RayQueue& queue, const Scheme& scheme,
               std::size_t queue_budget)
    : frame_(frame),
      stepper_(stepper),
      pool_(pool),
      queue_(queue),
      scheme_(scheme),
      queue_budget_(queue_budget),
      open_(pool, queue),
      depth_first_(frame, stepper) {}

void Worker::run() {
  while (!frame_.stopped()) {
    // Primary rays have the highest priority in every scheme: they are what makes a picture.
    if (const auto tile = frame_.next_tile()) {
      trace_tile(*tile);
      continue;
    }
    const RayQueue::Popped next = next_block();
    if (next.block == nullptr) return;
    trace_block(next);
    if (queue_.starving()) open_.flush();
  }
}

void Worker::trace_tile(std::uint32_t tile) {
  frame_.tiles().fill(tile, primaries_);
  stepper_.step_primary(primaries_.tasks, primaries_.rays);
  frame_.add(stepper_.light());
  frame_.tile_is_lit();
  keep_spawned(0);
}

void Worker::trace_block(const RayQueue::Popped& popped) {
  frame_.popped(key_of(popped.slot));
  stepper_.step(popped.block->span());
  frame_.add(stepper_.light());
  const std::uint64_t taken = render::ray_count(popped.block->span());
  pool_.release(popped.block);
  keep_spawned(taken);
}

// Of two equal slots the queue's block is preferred: it is the fuller one.
RayQueue::Popped Worker::next_block() {
  const int mine = open_.top();
  if (queue_.top() >= mine) {
    if (const RayQueue::Popped shared = queue_.pop(mine); shared.block != nullptr) return shared;
  }
  if (mine != kNoSlot) return {open_.take(static_cast<Slot>(mine)), static_cast<Slot>(mine)};
  return queue_.wait_and_pop();
}

void Worker::keep_spawned(std::uint64_t taken) {
  const std::span<const render::RayTask> spawned = stepper_.spawned();
  if (queue_budget_ != 0 && pool_.bytes() >= queue_budget_) {
    queue_.count(0, taken);
    depth_first_.run(spawned);
  } else {
    keys_.resize(spawned.size());
    scheme_.keys(spawned, keys_);
    queue_.count(render::ray_count(spawned), taken);
    open_.scatter(spawned, keys_);
  }
  frame_.traced(stepper_.counts().total() - reported_);
  reported_ = stepper_.counts().total();
}

}  // namespace firstlight::priority
