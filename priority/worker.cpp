#include "priority/worker.h"

#include "priority/steering.h"
#include "render/math/interrupt.h"

#include <algorithm>
#include <utility>

namespace firstlight::priority {

Worker::Worker(Frame& frame, render::Tracer& tracer, Shared& shared, const TraceOptions& options, std::size_t number)
    : frame_(frame),
      tracer_(tracer),
      shared_(shared),
      pool_(shared.pool),
      queue_(shared.queue),
      steering_(options.steering),
      number_(number),
      scheme_(options.scheme),
      open_(pool_, queue_, number),
      depth_first_(frame, tracer, tally_) {}

void Worker::run() {
  if (steering_ == nullptr) frame_.roots().sort(*scheme_, version_ = 1);
  while (!frame_.stopped()) {
    if (frame_.wants_rest()) rest();
    follow_order();
    if (queue_.idle() > 0) open_.send_full();
    if (queue_.has_stale()) {
      rekey_block();
    } else if (roots_are_next()) {
      trace_roots();
    } else if (const RayQueue::Popped next = next_block(); next.block != nullptr) {
      trace_blocks(next);
      if (queue_.starving()) open_.flush();
    } else if (queue_.closed()) {
      return;
    }
  }
  report();
  frame_.leave_unfinished();
}

void Worker::rest() {
  report();
  frame_.rest();
}

void Worker::follow_order() {
  if (steering_ == nullptr || version_ == steering_->version()) return;
  version_ = steering_->version();
  steered_ = steering_->scheme();
  scheme_ = steered_.get();
  open_.set_version(version_);
  queue_.begin_rekey(version_);
  frame_.roots().sort(*scheme_, version_);
}

void Worker::rekey_block() {
  Block* const block = queue_.pop_stale();
  if (block == nullptr) return;
  stale_.assign(block->tasks, block->tasks + block->count);
  open_.release(block);
  queue_tasks(stale_);
  queue_.rekeyed(static_cast<std::uint32_t>(stale_.size()));
}

bool Worker::roots_are_next() {
  const int roots = frame_.roots().top();
  if (roots == kNoSlot) return false;
  const int waiting = std::max(open_.top(), queue_.top());
  if (waiting == kNoSlot) return true;
  if (queue_is_long()) return false;
  if (pool_.budget() != 0) {
    // Near the budget what waits is traced first, until there is room for a good number of new rays.
    const std::size_t used = pool_.bytes();
    if (used >= pool_.budget() / 8 * 7) shared_.is_short_of_memory.store(true, std::memory_order_relaxed);
    if (used <= pool_.budget() / 2) shared_.is_short_of_memory.store(false, std::memory_order_relaxed);
    if (shared_.is_short_of_memory.load(std::memory_order_relaxed)) return false;
  }
  return roots >= waiting;
}

void Worker::trace_roots() {
  if (!frame_.roots().next(number_, roots_)) return;
  frame_.expect_light(roots_.rays.tasks);
  tracer_.step_primary(roots_.rays.tasks, roots_.rays.rays);
  if (render::Interrupt::seen()) return;  // half a step is no part of the sum
  frame_.add(tracer_, tally_);
  frame_.add_rest(roots_.rays, tally_);
  scheme_->learn(roots_.rays.tasks, tracer_.light(), tracer_.spawned());
  frame_.lit(roots_);
  keep_spawned(0);
}

void Worker::trace_blocks(const RayQueue::Popped& popped) {
  frame_.popped(key_of(popped.slot));
  const bool inverted = is_inverted(popped.slot);
  for (Block* block = popped.block; block != nullptr;) {
    Block* const next = block->next;
    if (frame_.wants_rest()) rest();
    if (frame_.stopped()) return;
    const std::uint64_t rays = trace_block(block);
    if (inverted) inverted_ += rays;
    block = next;
  }
}

bool Worker::is_inverted(Slot slot) const {
  return std::ranges::any_of(shared_.tops, [slot](const Shared::Top& top) {
    return top.slot.load(std::memory_order_relaxed) > static_cast<int>(slot);
  });
}

std::uint64_t Worker::trace_block(Block* block) {
  const std::uint64_t taken = render::ray_count(block->span());
  frame_.expect_light(block->span());
  tracer_.step(block->span());
  if (render::Interrupt::seen()) return 0;
  frame_.add(tracer_, tally_);
  scheme_->learn(block->span(), tracer_.light(), tracer_.spawned());
  open_.release(block);
  keep_spawned(taken);
  return taken;
}

// The queue's block is preferred of two equal slots: it is the fuller one.
RayQueue::Popped Worker::next_block() {
  if (open_.top_of_full() >= queue_.top()) open_.send_full();
  show_top(open_.top());
  if (queue_is_long()) {
    const int mine = open_.top(Among::shadows);
    const auto shared = queue_.pop(number_, mine, Among::shadows, kBlocksAtOnce);
    if (shared.block != nullptr) return shared;
    if (mine != kNoSlot) return {open_.take(static_cast<Slot>(mine)), static_cast<Slot>(mine)};
  }
  const int mine = open_.top();
  if (queue_.top() >= mine) {
    const auto shared = queue_.pop(number_, mine, Among::all, kBlocksAtOnce);
    if (shared.block != nullptr) return shared;
  }
  if (mine != kNoSlot) return {open_.take(static_cast<Slot>(mine)), static_cast<Slot>(mine)};
  open_.send_full();  // others may have taken what came before it
  show_top(kNoSlot);
  report();
  return queue_.wait_and_pop(number_, [this] { return refill(); });
}

bool Worker::refill() {
  if (frame_.roots().top() != kNoSlot) return true;
  if (!frame_.refill()) return false;
  frame_.roots().sort(*scheme_, version_);  // those of another pass have seen no scheme
  return true;
}

// Others look at it all the time, so it is changed only when it has to be.
void Worker::show_top(int slot) {
  std::atomic<int>& shown = shared_.tops[number_].slot;
  if (shown.load(std::memory_order_relaxed) != slot) shown.store(slot, std::memory_order_relaxed);
}

void Worker::keep_spawned(std::uint64_t taken) {
  count(render::ray_count(tracer_.spawned()), taken);
  queue_tasks(tracer_.spawned());
}

void Worker::count(std::uint64_t spawned, std::uint64_t taken) {
  constexpr int kBatchesOfReport = 8;
  const std::int64_t with_new = change_ + static_cast<std::int64_t>(spawned);
  highest_ = std::max(highest_, with_new);
  change_ = with_new - static_cast<std::int64_t>(taken);
  if (++batches_ == kBatchesOfReport) count_in_queue();
}

void Worker::count_in_queue() {
  queue_.count(change_, highest_);
  change_ = highest_ = batches_ = 0;
}

void Worker::report() {
  count_in_queue();
  shared_.inverted_rays.fetch_add(std::exchange(inverted_, 0), std::memory_order_relaxed);
  frame_.report(tracer_.counts(), tally_);
}

void Worker::queue_tasks(std::span<const render::RayTask> tasks) {
  keys_.resize(tasks.size());
  scheme_->keys(tasks, keys_);
  overflow_.clear();
  open_.scatter(tasks, keys_, overflow_);
  if (overflow_.empty()) return;
  count(0, render::ray_count(overflow_));
  depth_first_.run(overflow_);
}

}  // namespace firstlight::priority
