#pragma once

#include "priority/key.h"
#include "render/trace/ray_task.h"

#include <span>
#include <string_view>

namespace firstlight::priority {

/// Decides which waiting rays matter most. It sees ray tasks only, and never changes the finished picture.
///
/// Cost     one virtual call for a span of tasks, none a ray.
/// Threads  Immutable; keys() is called from all workers at once.
/// Source   Yagel & Meeker 1997, section 4.
class Scheme {
 public:
  virtual ~Scheme() = default;

  /// As on the command line.
  virtual std::string_view name() const = 0;
  /// keys[i] is the priority of tasks[i]. Pre: equal sizes.
  virtual void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const = 0;
};

}  // namespace firstlight::priority
