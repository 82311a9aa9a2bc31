#include "render/trace/area_shadow.h"

#include "render/light/arrival.h"
#include "render/math/interrupt.h"

#include <memory>
#include <utility>

namespace firstlight::render {
namespace {

/// Points of the grids of feelers that are worked on together; a larger grid is alone.
constexpr std::size_t kMostPoints = std::size_t{1} << 14;

std::size_t points_of(const Light& light) {
  return static_cast<std::size_t>(light.area->size1) * static_cast<std::size_t>(light.area->size2);
}

/// The colour of the light at a point, in single precision. With `area_illumination` what beam and distance leave is
/// asked for each point of the light, and has no part in the shadow. [POV-Ray 3.7]
Rgb arriving_at(const Light& light, const Vec3& point) {
  if (light.area_illumination) return light.color;
  Columns3<double> points;
  points.set(0, point);
  Arrival arrival;
  arrive(light, points, 1, nullptr, arrival);
  return light.color * static_cast<float>(arrival.share[0]);
}

}  // namespace

std::uint64_t AreaShadow::find(std::span<const Feeler> feelers, std::span<Rgb> shares) {
  std::uint64_t rays = 0;
  for (std::size_t first = 0; first < feelers.size() && !Interrupt::asked();) {
    std::size_t count = 0;
    std::size_t points = 0;
    do {
      points += points_of(scene_.lights[feelers[first + count].light]);
      ++count;
    } while (first + count < feelers.size() &&
             points + points_of(scene_.lights[feelers[first + count].light]) <= kMostPoints);
    rays += find_together(feelers.subspan(first, count), shares.subspan(first, count));
    first += count;
  }
  return rays;
}

std::uint64_t AreaShadow::find_together(std::span<const Feeler> feelers, std::span<Rgb> shares) {
  grids_.clear();
  regions_.clear();
  ray_count_ = 0;
  std::size_t points = 0;
  for (const Feeler& feeler : feelers) {
    const Light& light = scene_.lights[feeler.light];
    regions_.push_back({grids_.size(), {0, 0, light.area->size1 - 1, light.area->size2 - 1}, 1.0});
    grids_.push_back({&light,
                      AreaGrid(light, feeler.origin, AreaGrid::Use::shadow),
                      arriving_at(light, feeler.origin),
                      points,
                      {0.0, 0.0, 0.0}});
    points += points_of(light);
  }
  points_.assign(points, Point());
  for (int level = 0; !regions_.empty() && !Interrupt::asked(); ++level) {
    ask_corners(feelers);
    next_regions_.clear();
    for (const Region& region : regions_) look_at(region, level);
    std::swap(regions_, next_regions_);
  }
  for (std::size_t i = 0; i < feelers.size(); ++i) {
    const double* sum = grids_[i].sum;
    shares[i] = Rgb(static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2]));
  }
  return ray_count_;
}

void AreaShadow::ask_corners(std::span<const Feeler> feelers) {
  rays_.size = 0;
  for (const Region& region : regions_) {
    const Grid& grid = grids_[region.grid];
    const Feeler& feeler = feelers[region.grid];
    for (const auto& [u, v] : region.rectangle.corners()) {
      const std::size_t target = point_at(grid, u, v);
      if (std::exchange(points_[target].asked, true)) continue;
      const LightAim aim = aim_at(*grid.light, grid.places.place(u, v), feeler.origin);
      double max_depth = aim.depth - kShadowGap;
      if (!shadow_.end_at_window(*grid.light, {feeler.origin, aim.direction}, max_depth)) continue;
      const std::size_t i = rays_.size++;
      rays_.origin.set(i, feeler.origin);
      rays_.direction.set(i, aim.direction);
      rays_.min_depth[i] = kShadowGap;
      rays_.max_depth[i] = max_depth;
      rays_.hidden_bit[i] = kHiddenFromShadow;
      media_[i] = feeler.medium;
      lights_[i] = feeler.light;
      targets_[i] = target;
      if (rays_.size == kRaysAtOnce) send();
      if (Interrupt::asked()) return;
    }
  }
  if (rays_.size > 0) send();
}

void AreaShadow::send() {
  std::array<Rgb, kRaysAtOnce> shares;
  const std::size_t count = rays_.size;
  shadow_.passing(rays_, std::span(media_).first(count), std::span(lights_).first(count), std::span(shares).first(count));
  for (std::size_t i = 0; i < count; ++i) points_[targets_[i]].share = shares[i];
  ray_count_ += count;
  rays_.size = 0;
}

void AreaShadow::look_at(const Region& region, int level) {
  Grid& grid = grids_[region.grid];
  const auto corners = region.rectangle.corners();
  std::array<Rgb, 4> shares;
  std::array<Rgb, 4> colors;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    shares[i] = points_[point_at(grid, corners[i][0], corners[i][1])].share;
    colors[i] = grid.arriving * shares[i];
  }
  if (region.rectangle.has_quarters() && (level < grid.light->adaptive || differ(colors))) {
    const AreaQuarters quarters = quarters_of(region.rectangle);
    for (std::size_t i = 0; i < quarters.size; ++i) {
      next_regions_.push_back({region.grid, quarters.of[i], region.weight * 0.25 * quarters.times});
    }
    return;
  }
  for (int c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (const Rgb& share : shares) sum += static_cast<double>(share[c]);
    grid.sum[c] += 0.25 * region.weight * sum;
  }
}

}  // namespace firstlight::render
