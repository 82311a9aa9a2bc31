#pragma once

#include "priority/depth_first.h"
#include "priority/frame.h"
#include "priority/open_blocks.h"
#include "priority/ray_queue.h"
#include "priority/scheme.h"
#include "render/trace/step.h"

#include <cstddef>
#include <span>
#include <vector>

namespace firstlight::priority {

/// One thread's loop around the queue: takes the most important rays there are, traces them, and puts what comes of
/// them back by importance.
class Worker {
 public:
  /// `queue_budget`: bytes of waiting rays beyond which nothing more is queued; 0: no limit.
  Worker(Frame& frame, render::Stepper& stepper, BlockPool& pool, RayQueue& queue, const Scheme& scheme,
         std::size_t queue_budget);

  /// Until nothing is left or the frame is stopped.
  void run();

 private:
  void trace_tile(std::uint32_t tile);
  void trace_block(const RayQueue::Popped& popped);
  RayQueue::Popped next_block();
  /// Queues what the last step spawned; `taken` rays had left the queue for it.
  void keep_spawned(std::uint64_t taken);

  Frame& frame_;
  render::Stepper& stepper_;
  BlockPool& pool_;
  RayQueue& queue_;
  const Scheme& scheme_;
  const std::size_t queue_budget_;
  OpenBlocks open_;
  DepthFirst depth_first_;
  render::PrimaryBatch primaries_;
  std::vector<Key> keys_;
  std::uint64_t reported_ = 0;  // rays of which the frame knows
};

}  // namespace firstlight::priority
