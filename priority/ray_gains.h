#pragma once

#include "priority/cells.h"
#include "priority/running_ratio.h"
#include "render/math/fixed_rgb.h"

#include <atomic>
#include <cstddef>
#include <vector>

namespace firstlight::priority {

/// How much light a reflected or transmitted ray of weight 1 brings for each ray it costs, learnt from those that were
/// traced: by square of the picture and level. A mirror brings little itself, but what it shows may be bright: a ray
/// counts for the best of what it brings alone, or with the rays of the next levels for what they all cost.
///
/// Units    Mean of the channels, white being 1.
/// Cost     gain(): one look into a table. The others: some ten nanoseconds, so they are not told everything; the same
///          share of the rays traced and of those spawned.
/// Threads  All members may be called from any thread; what others have learnt is seen a little later.
class RayGains {
 public:
  explicit RayGains(const Cells& cells);

  float gain(std::size_t cell, const render::RayTask& ray) const {
    return gains_[place(cell, ray.level)].load(std::memory_order_relaxed);
  }
  void learn_traced(std::size_t cell, const render::RayTask& ray, const render::FixedRgb& light);
  /// Pre: not a feeler.
  void learn_spawned(std::size_t cell, const render::RayTask& ray);

 private:
  static constexpr std::size_t kLevels = 8;
  /// Gains of all rays of a level in a square; per ray traced there but `light` and `passed_on`, which are per weight.
  struct Level {
    RunningRatio light;
    RunningRatio passed_on;  ///< weight of the rays of the next level
    RunningRatio rays;       ///< of the next level
  };

  static std::size_t place(std::size_t cell, std::size_t level) {
    return cell * kLevels + std::min(level, kLevels - 1);
  }
  float best_gain(std::size_t cell, std::size_t level) const;

  std::vector<Level> levels_;
  std::vector<std::atomic<float>> gains_;
};

/// The mean of the channels' sizes: pictures are compared by the sum of their channels' differences.
inline float mean_magnitude(const render::Rgb& color) {
  return (std::abs(color.x) + std::abs(color.y) + std::abs(color.z)) * (1.0f / 3.0f);
}

}  // namespace firstlight::priority
