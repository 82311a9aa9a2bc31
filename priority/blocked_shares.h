#pragma once

#include "priority/cells.h"
#include "priority/running_ratio.h"
#include "render/math/fixed_rgb.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace firstlight::priority {

/// How likely feelers are blocked, learnt from those that were traced: by square of the picture, light and whether the
/// surface is seen directly.
///
/// Cost     share(): one look into a table. learn(): some ten nanoseconds, so it is not told everything.
/// Threads  All members may be called from any thread; what others have learnt is seen a little later.
class BlockedShares {
 public:
  BlockedShares(const Cells& cells, std::size_t lights);

  /// Where the shares of a record's feelers begin.
  std::size_t base(std::size_t cell, const render::RayTask& task) const {
    return (cell * kDepths + (task.level > 1 ? 1 : 0)) * lights_;
  }
  float share(std::size_t base, std::uint32_t light) const {
    return shares_[base + place_of(light)].load(std::memory_order_relaxed);
  }
  /// `light`: what the record of feelers changed.
  void learn(std::size_t cell, const render::RayTask& feelers, const render::FixedRgb& light);

 private:
  static constexpr std::size_t kDepths = 2;
  static constexpr std::size_t kMostLights = 8;  // further ones share the numbers of these

  std::size_t place_of(std::uint32_t light) const { return light < lights_ ? light : light % lights_; }
  void learn(std::size_t place, float blocked);

  std::size_t lights_;
  std::vector<RunningRatio> seen_;
  std::vector<std::atomic<float>> shares_;  ///< estimates of the same
};

}  // namespace firstlight::priority
