#pragma once

#include "render/math/fixed_rgb.h"
#include "render/trace/ray_task.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace firstlight::render {

struct Camera;
struct Scene;
class SurfaceTable;

/// The most light that a ray can bring to its sample, all its descendants included: what the remaining error of a
/// picture in progress is bounded by.
///
/// Units    Of any channel, white being 1; at_stake() in the steps of FixedRgb.
/// Source   No surface gives more than its own light and its highlights under all lights at their brightest, and what
///          it reflects and lets through of the most that the next level can bring (surface_limits.h).
/// Exact    to the rounding of the film, half a step an addition.
/// Threads  Immutable.
class RadianceBound {
 public:
  explicit RadianceBound(const Scene& scene);
  /// Bounds the scene as `camera` sees it. `surfaces`: of the scene.
  RadianceBound(const Scene& scene, const Camera& camera, const SurfaceTable& surfaces, bool with_alpha = false);

  /// False where there is no bound, and at_stake() is an estimate: rows of surfaces that take no light away but add
  /// some, as clear glass without refraction does with its highlights, may be of any length; the estimate allows for
  /// four in a row. Matter, filters and powers may be described that make more light of little. In random scenes of
  /// the first kind the estimate held at every moment, of the second kind at 99.9 % (radiance_bound_test.cpp).
  bool known() const { return known_; }
  /// The most that a ray of weight 1 brings whose parent has the given trace level; does not grow with the level.
  float most(int level) const { return most_[static_cast<std::size_t>(level)]; }

  /// The most that a task can still change any channel of its sample; at least 1, so that the sum over the tasks of a
  /// sample is 0 exactly when none is left.
  std::int64_t at_stake(const RayTask& task) const {
    if (task.kind == RayKind::shadow) return of_feelers(task);
    if ((task.flags & RayTask::kSeesThrough) != 0) return 1 + FixedRgb::to_fixed(task.max_weight());
    const bool continued = (task.flags & RayTask::kContinued) != 0;
    float most = this->most(continued && task.level > 0 ? task.level - 1 : task.level);
    if (task.kind == RayKind::primary) most = std::max(most, most_clear_);
    return 1 + FixedRgb::to_fixed(task.max_weight() * most);
  }

  /// The most that feelers may take back which hold `held` in the channel that has most. Where nothing is proved, what
  /// they cross may make more light of theirs: a quarter more is allowed for.
  std::int64_t most_of_feelers(std::int64_t held) const { return known_ ? held : held + held / 4; }

 private:
  std::int64_t of_feelers(const RayTask& task) const;

  std::vector<float> most_;  // by level
  float most_clear_ = 0.0f;  // that shows through
  bool known_ = true;
};

}  // namespace firstlight::render
