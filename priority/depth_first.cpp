#include "priority/depth_first.h"

#include "render/math/interrupt.h"

namespace firstlight::priority {
namespace {

// The ray on top of the stack, or all feelers there: siblings, whose order makes no difference and which have no
// children.
std::size_t size_of_top(std::span<const render::RayTask> stack) {
  std::size_t count = 1;
  if (stack.back().kind != render::RayKind::shadow) return count;
  while (count < stack.size() && stack[stack.size() - count - 1].kind == render::RayKind::shadow) ++count;
  return count;
}

}  // namespace

void DepthFirst::run(std::span<const render::RayTask> roots) {
  stack_.assign(roots.begin(), roots.end());
  while (!stack_.empty() && !frame_.stopped()) {
    const std::size_t count = size_of_top(stack_);
    tracer_.step(std::span(stack_).last(count));
    if (render::Interrupt::seen()) return;  // half a step is no part of the sum
    frame_.add(tracer_, tally_);
    stack_.resize(stack_.size() - count);
    stack_.insert(stack_.end(), tracer_.spawned().begin(), tracer_.spawned().end());
  }
}

void trace_recursively(Frame& frame, render::Tracer& tracer, RayQueue& queue, std::size_t worker) {
  Tally tally;
  DepthFirst depth_first(frame, tracer, tally);
  Roots roots;
  while (!queue.closed()) {
    if (!frame.roots().next(worker, roots)) {
      frame.report(tracer.counts(), tally);
      queue.wait_and_pop(worker, [&frame] { return frame.refill(); });
      continue;
    }
    const render::PrimaryBatch& batch = roots.rays;
    for (std::size_t i = 0; i < batch.tasks.size(); ++i) {
      if (frame.wants_rest()) {
        frame.report(tracer.counts(), tally);
        frame.rest();
      }
      if (frame.stopped()) {
        frame.report(tracer.counts(), tally);
        return frame.leave_unfinished();
      }
      tracer.step_primary(std::span(batch.tasks).subspan(i, 1), std::span(batch.rays).subspan(i, 1));
      if (render::Interrupt::seen()) {
        frame.report(tracer.counts(), tally);
        return frame.leave_unfinished();
      }
      frame.add(tracer, tally);
      depth_first.run(tracer.spawned());
    }
    frame.add_rest(batch, tally);
    frame.lit(roots);
  }
}

}  // namespace firstlight::priority
