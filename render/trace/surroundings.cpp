// The surroundings that rays see besides surfaces: fog and rainbows on their way, the sky behind everything.

#include "render/trace/step.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace firstlight::render {

void Stepper::see_surroundings(std::span<const RayTask> tasks, std::span<Contribution> light) {
  if (!veils_of_scene_.empty()) {
    std::uint64_t veiled = 0;
    Column<double> depth{};
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      depth[i] = hits_[i].part == kNoIndex ? std::min(kSkyDepth, rays_->max_depth[i]) : hits_[i].depth;
      veiled |= std::uint64_t{is_hollow(context_.scene, context_.media, tasks[i].medium)} << i;
    }
    veils_of_scene_.across(veiled, tasks.size(), *rays_, depth, veils_);
    for (std::uint64_t rest = veiled; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      if ((tasks[i].flags & RayTask::kSeesThrough) != 0) continue;
      light[i].light += FixedRgb::from(tasks[i].weight() * veils_[i].added);
    }
  }
  std::uint64_t misses = 0;
  std::uint64_t asking = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    misses |= static_cast<std::uint64_t>(hits_[i].part == kNoIndex) << i;
    asking |= static_cast<std::uint64_t>((tasks[i].flags & RayTask::kReflected) == 0) << i;
  }
  if (misses == 0) return;
  if (!context_.with_alpha) return see_sky(tasks, misses, light);
  see_sky(tasks, misses & ~asking, light);
  see_through_sky(tasks, misses & asking, light);
}

void Stepper::see_sky(std::span<const RayTask> tasks, std::uint64_t misses, std::span<Contribution> light) {
  const Sky& sky = table_->sky();
  const Rgb background = context_.with_alpha ? sky.background_with_alpha().rgb : sky.background();
  if (sky.is_even()) {
    for (; misses != 0; misses &= misses - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(misses));
      light[i].light += FixedRgb::from(light_weight(tasks[i], i) * background);
    }
    return;
  }
  Columns3<double> directions;
  Columns3<float> colors;
  const std::size_t count = gather_directions(misses, directions);
  sky.colors(directions, count, background, colors);
  for (std::size_t k = 0; misses != 0; misses &= misses - 1, ++k) {
    const auto i = static_cast<std::size_t>(std::countr_zero(misses));
    light[i].light += FixedRgb::from(light_weight(tasks[i], i) * colors.vector(k));
  }
}

void Stepper::see_through_sky(std::span<const RayTask> tasks, std::uint64_t misses, std::span<Contribution> light) {
  Columns3<double> directions;
  Columns3<float> colors;
  Column<float> clear;
  const std::size_t count = gather_directions(misses, directions);
  table_->sky().colors_with_alpha(directions, count, colors, clear);
  for (std::size_t k = 0; misses != 0; misses &= misses - 1, ++k) {
    const auto i = static_cast<std::size_t>(std::countr_zero(misses));
    light[i].light += FixedRgb::from(light_weight(tasks[i], i) * colors.vector(k));
    if (const float weight = clear_weight(tasks[i], i); weight != 0.0f) {
      clearness_.push_back({tasks[i].sample, FixedRgb::to_fixed(weight * clear[k])});
    }
  }
}

std::size_t Stepper::gather_directions(std::uint64_t misses, Columns3<double>& directions) const {
  std::size_t count = 0;
  for (; misses != 0; misses &= misses - 1) {
    directions.set(count++, rays_->direction.vector(static_cast<std::size_t>(std::countr_zero(misses))));
  }
  return count;
}

}  // namespace firstlight::render
