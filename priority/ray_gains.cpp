#include "priority/ray_gains.h"

#include <algorithm>

namespace firstlight::priority {
namespace {

// Beliefs where nothing is known, and how many rays it takes to believe something else.
constexpr float kLightBefore = 0.4f;
constexpr float kPassedOnBefore = 0.4f;
constexpr float kRaysBefore = 0.7f;
constexpr float kTrust = 4.0f;

constexpr std::size_t kAhead = 3;    ///< levels that are looked at
constexpr float kBrightest = 16.0f;  ///< a highlight must not spoil the mean for long
constexpr float kFewRays = 0.01f;

}  // namespace

RayGains::RayGains(const Cells& cells) : levels_(cells.count() * kLevels), gains_(levels_.size()) {
  for (std::size_t level = 0; level < kLevels; ++level) {
    const float gain = best_gain(0, level);
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
      gains_[place(cell, level)].store(gain, std::memory_order_relaxed);
    }
  }
}

void RayGains::learn_traced(std::size_t cell, const render::RayTask& ray, const render::FixedRgb& light) {
  const float weight = mean_magnitude(ray.weight());
  const float brought = std::min(mean_magnitude(light.to_rgb()), kBrightest * weight);
  if (!(weight <= kBrightest && brought >= 0.0f)) return;  // not-a-number and infinity
  Level& level = levels_[place(cell, ray.level)];
  level.light.add(brought, weight);
  level.passed_on.add(0.0f, weight);
  level.rays.add(0.0f, 1.0f);
  gains_[place(cell, ray.level)].store(best_gain(cell, ray.level), std::memory_order_relaxed);
}

void RayGains::learn_spawned(std::size_t cell, const render::RayTask& ray) {
  const float weight = mean_magnitude(ray.weight());
  if (ray.level == 0 || !(weight <= kBrightest)) return;
  Level& level = levels_[place(cell, ray.level - 1u)];
  level.passed_on.add(weight, 0.0f);
  level.rays.add(1.0f, 0.0f);
}

float RayGains::best_gain(std::size_t cell, std::size_t level) const {
  float best = 0.0f;
  float light = 0.0f;
  float cost = 0.0f;
  float weight = 1.0f;
  float rays = 1.0f;
  for (std::size_t l = level; l < level + kAhead; ++l) {
    const Level& here = levels_[place(cell, l)];
    light += weight * here.light.estimate(kLightBefore, kTrust);
    cost += rays;
    best = std::max(best, light / cost);
    weight *= here.passed_on.estimate(kPassedOnBefore, kTrust);
    rays *= here.rays.estimate(kRaysBefore, kTrust);
    if (!(rays > kFewRays)) break;
  }
  return best;
}

}  // namespace firstlight::priority
