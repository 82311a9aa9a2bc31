#pragma once

#include "render/math/fixed_rgb.h"
#include "render/trace/ray_task.h"

#include <cstdint>
#include <optional>
#include <span>

namespace firstlight::priority {

/// Where the light of a pass goes.
///
/// Threads  expect(): one thread, before anything is added. The rest: any thread.
class Sink {
 public:
  virtual ~Sink() = default;

  /// Those that its first roots light, of which it tells progress.
  virtual std::uint64_t samples() const = 0;
  /// Each sample's root can bring `most` at most, in steps of FixedRgb.
  virtual void expect(std::int64_t most) = 0;
  virtual void add(std::span<const render::Contribution> light) = 0;
  /// The same of what shows through, for sinks that ask; before the light of the same rays.
  virtual void add_clearness(std::span<const render::Clearness> /*clearness*/) {}
  /// Light will be added to the tasks' samples soon.
  virtual void fetch(std::span<const render::RayTask> /*tasks*/) const {}
  /// The sum over its samples of the most that each may still change, where that is not what the waiting rays may
  /// bring; the sink of some samples that has told it once tells it always. Cost: a look at each sample.
  virtual std::optional<double> outstanding() const { return std::nullopt; }
};

}  // namespace firstlight::priority
