#pragma once

#include "priority/frame.h"
#include "priority/ray_queue.h"
#include "render/trace/tracer.h"

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
  DepthFirst(Frame& frame, render::Tracer& tracer, Tally& tally) : frame_(frame), tracer_(tracer), tally_(tally) {}

  /// Pre: `roots` may be the tracer's spawned().
  void run(std::span<const render::RayTask> roots);

 private:
  Frame& frame_;
  render::Tracer& tracer_;
  Tally& tally_;
  std::vector<render::RayTask> stack_;
};

/// The traditional order, the baseline of all comparisons: root by root, each with its whole tree, depth first. The
/// workers only meet at the `queue`, when there are no more pixels. `worker`: the number of the calling one.
void trace_recursively(Frame& frame, render::Tracer& tracer, RayQueue& queue, std::size_t worker);

}  // namespace firstlight::priority
