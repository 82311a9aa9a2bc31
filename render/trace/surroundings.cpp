// The surroundings that rays see besides surfaces: fog and rainbows on their way, the sky behind everything.

#include "render/trace/step.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace firstlight::render {

void Stepper::see_surroundings(std::span<const RayTask> tasks, std::span<Contribution> light) {
  const Sky& sky = table_->sky();
  const bool is_veiled = !veils_of_scene_.empty();
  if (is_veiled) {
    std::uint64_t veiled = 0;
    Column<double> depth{};
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      depth[i] = hits_[i].part == kNoIndex ? std::min(kSkyDepth, rays_->max_depth[i]) : hits_[i].depth;
      veiled |= std::uint64_t{is_hollow(context_.scene, context_.media, tasks[i].medium)} << i;
    }
    veils_of_scene_.across(veiled, tasks.size(), *rays_, depth, veils_);
    for (std::uint64_t rest = veiled; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      light[i].light += FixedRgb::from(tasks[i].weight() * veils_[i].added);
    }
  }
  const auto weight = [&](std::size_t i) { return is_veiled ? tasks[i].weight() * veils_[i].kept : tasks[i].weight(); };
  std::uint64_t misses = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    misses |= static_cast<std::uint64_t>(hits_[i].part == kNoIndex) << i;
  }
  if (misses == 0) return;
  if (sky.is_even()) {
    for (; misses != 0; misses &= misses - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(misses));
      light[i].light += FixedRgb::from(weight(i) * sky.background());
    }
    return;
  }
  Columns3<double> directions;
  Columns3<float> colors;
  std::size_t count = 0;
  for (std::uint64_t rest = misses; rest != 0; rest &= rest - 1) {
    directions.set(count++, rays_->direction.vector(static_cast<std::size_t>(std::countr_zero(rest))));
  }
  sky.colors(directions, count, colors);
  for (std::size_t k = 0; misses != 0; misses &= misses - 1, ++k) {
    const auto i = static_cast<std::size_t>(std::countr_zero(misses));
    light[i].light += FixedRgb::from(weight(i) * colors.vector(k));
  }
}

}  // namespace firstlight::render
