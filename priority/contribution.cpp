#include "priority/blocked_shares.h"
#include "priority/cells.h"
#include "priority/log_scale.h"
#include "priority/ray_gains.h"
#include "priority/schemes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace firstlight::priority {
namespace {

using render::PackedRgb;
using render::RayKind;
using render::RayTask;

/// The share of its light that a reflected or transmitted ray counts for, against the light that a feeler takes back:
/// it brings lights that feelers have still to take back, and costs several times what a feeler does.
constexpr float kRayShare = 0.08f;
/// Nothing is known of a primary ray when its turn is decided. A small gain lets the coarse pixels be nearly finished
/// before the finest begin, as the preview fills those meanwhile; and it keeps the queue short, for memory's first
/// touch costs more time than the order gains: with 0.005 the queue is twice as long.
constexpr float kPrimaryGain = 0.003f;

/// Waiting rays a pixel beyond which feelers come first, so that the queue grows no longer where feelers are many.
constexpr double kLongQueue = 4.5;

/// Tasks of which one is learnt from: neighbours tell much the same, and learning takes time.
constexpr std::size_t kLearnOneOf = 32;

/// Half an octave a key: finer ones converge no faster, and leave more blocks half empty.
constexpr LogScale kScale(-30, 10, 1);
/// Feelers have every fourth key only, the lowest of four: those whose ends are not foreseen are few, and would be a few
/// in a block.
constexpr Key kKeysOfFeelers = 4;

/// The more a ray can be expected to change the picture for what it costs, the earlier it leaves. Of a record of
/// feelers this is the light at stake times the share of feelers that are blocked thereabouts, for each feeler; of
/// another ray its weight times the light that such rays bring.
///
/// Order    learnt while rendering: the same task may get another key later.
/// Source   Yagel & Meeker 1997, section 4, "contribution", which takes the weight alone.
class Contribution final : public Scheme {
 public:
  explicit Contribution(const SchemeInput& input)
      : cells_(input), blocked_(cells_, input.scene.lights.size()), gains_(cells_) {}

  void keys(std::span<const RayTask> tasks, std::span<Key> keys) const override {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      keys[i] = kScale.of(gain(tasks[i]));
      if (tasks[i].kind == RayKind::shadow) keys[i] -= keys[i] % kKeysOfFeelers;
    }
  }
  Key key_count() const override { return kScale.count(); }
  bool tells_pixels_apart() const override { return false; }
  double long_queue() const override { return kLongQueue; }

  void learn(std::span<const RayTask> tasks, std::span<const render::Contribution> light,
             std::span<const RayTask> spawned) const override {
    for (std::size_t i = 0; i < std::min(tasks.size(), light.size()); i += kLearnOneOf) {
      const std::size_t cell = cells_.of(tasks[i]);
      if (tasks[i].kind == RayKind::shadow) {
        blocked_.learn(cell, tasks[i], light[i].light);
      } else {
        gains_.learn_traced(cell, tasks[i], light[i].light);
      }
    }
    for (std::size_t i = 0; i < spawned.size(); i += kLearnOneOf) {
      if (spawned[i].kind != RayKind::shadow) gains_.learn_spawned(cells_.of(spawned[i]), spawned[i]);
    }
  }

 private:
  float gain(const RayTask& task) const {
    if (task.kind == RayKind::primary) return task.max_weight() * kPrimaryGain;
    const std::size_t cell = cells_.of(task);
    if (task.kind != RayKind::shadow) {
      return mean_magnitude(task.weight()) * gains_.gain(cell, task) * kRayShare;
    }
    float sum = 0.0f;
    const std::size_t base = blocked_.base(cell, task);
    task.for_each_feeler([&](std::uint32_t light, const PackedRgb& at_stake) {
      sum += at_stake.sum_of_magnitudes() * blocked_.share(base, light);
    });
    static constexpr std::array<float, 1 + RayTask::kMostFeelers> kMeanOfChannels{0.0f, 1.0f / 3, 1.0f / 6};
    return sum * kMeanOfChannels[static_cast<std::size_t>(task.ray_count())];
  }

  Cells cells_;
  mutable BlockedShares blocked_;
  mutable RayGains gains_;
};

}  // namespace

SchemePtr make_contribution(const SchemeInput& input, SchemeText*) { return std::make_shared<Contribution>(input); }

}  // namespace firstlight::priority
