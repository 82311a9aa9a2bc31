#pragma once

#include "priority/key.h"
#include "render/math/fixed_rgb.h"
#include "render/trace/ray_task.h"

#include <limits>
#include <span>

namespace firstlight::priority {

/// Decides which waiting rays matter most. It sees ray tasks only, and never changes the finished picture.
///
/// Cost     one virtual call for a span of tasks, none a ray; a few nanoseconds a ray.
/// Threads  All members may be called from all workers at once.
/// Source   Yagel & Meeker 1997, section 4.
class Scheme {
 public:
  virtual ~Scheme() = default;

  /// keys[i] is the priority of tasks[i], less than key_count(). The same task may get another key later, when more has
  /// been learnt. Pre: equal sizes.
  virtual void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const = 0;
  /// How many keys there are; at most kBuckets, at least 1. Does not change.
  virtual Key key_count() const = 0;
  /// Waiting rays, for each sample of the picture, beyond which feelers leave before all others: they have no children,
  /// so the queue grows shorter. Infinite: the order is kept however long the queue.
  virtual double long_queue() const { return std::numeric_limits<double>::infinity(); }
  /// Whether primary rays of different pixels may have different keys. A scheme that does not look at the pixel says
  /// no, which saves asking for each of them.
  virtual bool tells_pixels_apart() const { return true; }
  /// Tells what came of tasks that were traced: light[i] is what tasks[i] changed, `spawned` the rays that all of them
  /// sent on.
  virtual void learn(std::span<const render::RayTask> /*tasks*/, std::span<const render::Contribution> /*light*/,
                     std::span<const render::RayTask> /*spawned*/) const {}
};

}  // namespace firstlight::priority
