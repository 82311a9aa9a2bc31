#pragma once

#include "priority/frame.h"
#include "priority/ray_queue.h"
#include "render/trace/step.h"

#include <span>
#include <vector>

namespace firstlight::priority {

/// Traces rays with all that come of them at once, depth first, keeping what still has to be done on a stack.
///
/// Memory   the siblings on the way from a root to the ray at hand.
/// Threads  One a thread.
class DepthFirst {
 public:
  /// Pre: all outlive this.
  DepthFirst(Frame& frame, render::Stepper& stepper, Tally& tally) : frame_(frame), stepper_(stepper), tally_(tally) {}

  /// Pre: `roots` may be the stepper's spawned().
  void run(std::span<const render::RayTask> roots);

 private:
  Frame& frame_;
  render::Stepper& stepper_;
  Tally& tally_;
  std::vector<render::RayTask> stack_;
};

/// The traditional order, the baseline of all comparisons: pixel by pixel, each with its whole tree, depth first. The
/// workers only meet at the `queue`, when there are no more pixels. `worker`: the number of the calling one.
void trace_recursively(Frame& frame, render::Stepper& stepper, RayQueue& queue, std::size_t worker);

}  // namespace firstlight::priority
