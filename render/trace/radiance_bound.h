#pragma once

#include "render/scene/scene.h"
#include "render/trace/ray_task.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// The most light that a ray can bring to its sample, all its descendants included: what the remaining error of a
/// picture in progress is bounded by.
///
/// Units    Of any channel, white being 1; at_stake() in the steps of FixedRgb.
/// Source   No surface gives more than its own light and its highlights under all lights at their brightest, and what
///          it reflects and lets through of the most that the next level can bring.
/// Threads  Immutable.
class RadianceBound {
 public:
  explicit RadianceBound(const Scene& scene);

  /// False where no bound is known: endless rows of clear surfaces, each with a highlight. at_stake() is a guess then.
  bool known() const { return known_; }
  /// Of a ray of weight 1 whose parent has the given trace level; does not grow with the level.
  float most(int level) const { return most_[static_cast<std::size_t>(level)]; }

  /// The most that a task can still change any channel of its sample; at least 1, so that the sum over the tasks of a
  /// sample is 0 exactly when none is left.
  std::int64_t at_stake(const RayTask& task) const;

 private:
  std::vector<float> most_;  // by level
  bool known_ = true;
};

}  // namespace firstlight::render
