#pragma once

#include "priority/depth_first.h"
#include "priority/frame.h"
#include "priority/open_blocks.h"
#include "priority/ray_queue.h"
#include "priority/scheme.h"
#include "render/trace/tracer.h"

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace firstlight::priority {

/// The means that the workers of a queued order share.
struct Shared {
  Shared(const TraceOptions& options, std::uint64_t samples_of_all)
      : pool(options.queue_memory, options.block_size),
        queue(pool, options.threads),
        samples(static_cast<double>(samples_of_all)),
        tops(static_cast<std::size_t>(options.threads)) {}

  /// The highest slot of a worker's open blocks when it last looked for work; on a line of its own, for it changes
  /// often.
  struct alignas(64) Top {
    std::atomic<int> slot = kNoSlot;
  };

  BlockPool pool;
  RayQueue queue;
  const double samples;
  std::vector<Top> tops;  ///< of each worker
  std::atomic<bool> is_short_of_memory = false;
  std::atomic<std::uint64_t> inverted_rays = 0;
};

/// One thread's loop around the queue: takes the most important rays there are, traces them, and puts what comes of
/// them back by importance.
class Worker {
 public:
  /// `number` of [0, options.threads).
  Worker(Frame& frame, render::Tracer& tracer, Shared& shared, const TraceOptions& options, std::size_t number);

  /// Until nothing is left or the frame is stopped.
  void run();

 private:
  /// Few enough to keep to the order, enough that workers seldom meet at the queue.
  static constexpr int kBlocksAtOnce = 4;

  /// Takes up a changed order.
  void follow_order();
  void rekey_block();
  /// Whether the scheme wants feelers first, for so many rays wait.
  bool queue_is_long() const { return static_cast<double>(queue_.waiting()) > scheme_->long_queue() * shared_.samples; }
  /// Whether the next roots come before all that waits, and have room.
  bool roots_are_next();
  void trace_roots();
  void trace_blocks(const RayQueue::Popped& popped);
  /// Returns how many rays it had.
  std::uint64_t trace_block(Block* block);
  /// Whether more important rays wait in others' open blocks.
  bool is_inverted(Slot slot) const;
  RayQueue::Popped next_block();
  /// To be called when nothing waits. Whether there are roots again.
  bool refill();
  void show_top(int slot);
  /// Queues what the last step spawned; `taken` rays had left the queue for it.
  void keep_spawned(std::uint64_t taken);
  void count(std::uint64_t spawned, std::uint64_t taken);
  void count_in_queue();
  void rest();
  /// Makes known what only this worker knows.
  void report();
  void queue_tasks(std::span<const render::RayTask> tasks);

  Frame& frame_;
  render::Tracer& tracer_;
  Shared& shared_;
  BlockPool& pool_;
  RayQueue& queue_;
  const Steering* const steering_;
  const std::size_t number_;
  const Scheme* scheme_;
  std::shared_ptr<const Scheme> steered_;  // what scheme_ is after a change
  std::uint64_t version_ = 0;
  OpenBlocks open_;
  Tally tally_;
  DepthFirst depth_first_;
  Roots roots_;
  std::vector<Key> keys_;
  std::vector<render::RayTask> overflow_;
  std::vector<render::RayTask> stale_;
  // Rays that wait and are not counted by the queue yet:
  std::int64_t change_ = 0;
  std::int64_t highest_ = 0;
  int batches_ = 0;
  std::uint64_t inverted_ = 0;  // rays traced before more important ones, not reported yet
};

}  // namespace firstlight::priority
