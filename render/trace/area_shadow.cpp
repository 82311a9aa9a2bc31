#include "render/trace/area_shadow.h"

#include "render/light/arrival.h"
#include "render/math/interrupt.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/trace/area_shadow.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/lanes-inl.h"

#include <algorithm>
#include <memory>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// The rays' directions to the places and how far those are, but for rays in `aimed`.
void aim_at_places(const Columns3<double>& places, std::uint64_t aimed, RayBlock& rays) {
  for (std::size_t i = 0; i < rays.size; i += Lanes::kCount) {
    const Vec3Of<Lanes> way = load3<Lanes>(places, i) - load3<Lanes>(rays.origin, i);
    const Lanes distance = length(way);
    const auto stay = Lanes::mask_of(static_cast<unsigned>(aimed >> i & kAllLanes));
    const Lanes inverse = select(distance > 0.0, Lanes(1.0) / distance, Lanes(0.0));
    store3(select<Lanes>(stay, load3<Lanes>(rays.direction, i), way * inverse), rays.direction, i);
    store(select(stay, load<Lanes>(rays.max_depth, i), distance - kShadowGap), rays.max_depth, i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(aim_at_places);

namespace {

/// Points of the grids of feelers that are worked on together; a larger grid is alone.
constexpr std::size_t kMostPoints = std::size_t{1} << 14;

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

AreaShadow::AreaShadow(const Scene& scene, Shadow& shadow) : scene_(scene), shadow_(shadow) {
  for (const Light& light : scene.lights) {
    table_of_.push_back(tables_.size());
    if (light.area) tables_.emplace_back(light);
  }
}

std::uint64_t AreaShadow::find(std::span<const Feeler> feelers, std::span<Rgb> shares) {
  std::uint64_t rays = 0;
  for (std::size_t first = 0; first < feelers.size() && !Interrupt::asked();) {
    std::size_t count = 0;
    std::size_t points = 0;
    do {
      points += scene_.lights[feelers[first + count].light].area->points();
      ++count;
    } while (first + count < feelers.size() &&
             points + scene_.lights[feelers[first + count].light].area->points() <= kMostPoints);
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
                      &tables_[table_of_[feeler.light]],
                      AreaGrid(light, feeler.origin, AreaGrid::Use::shadow),
                      arriving_at(light, feeler.origin),
                      points,
                      {0.0, 0.0, 0.0}});
    points += light.area->points();
  }
  asked_.assign(points, 0);
  if (shares_.size() < points) shares_.resize(points);
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
  aimed_ = 0;
  for (const Region& region : regions_) {
    const Grid& grid = grids_[region.grid];
    const Feeler& feeler = feelers[region.grid];
    for (const auto& [u, v] : region.rectangle.corners()) {
      const std::size_t number = number_of(grid, u, v);
      const std::size_t target = grid.first_point + number;
      if (std::exchange(asked_[target], 1) != 0) continue;
      shares_[target] = Rgb(0.0f);
      const Vec3 place = grid.table->empty() ? grid.places.place(u, v) : grid.places.place((*grid.table)[number]);
      const std::size_t i = rays_.size;
      if (grid.light->parallel || grid.light->window != Light::kNoWindow) {
        const LightAim aim = aim_at(*grid.light, place, feeler.origin);
        double max_depth = aim.depth - kShadowGap;
        if (!shadow_.end_at_window(*grid.light, {feeler.origin, aim.direction}, max_depth)) continue;
        rays_.direction.set(i, aim.direction);
        rays_.max_depth[i] = max_depth;
        aimed_ |= std::uint64_t{1} << i;
      }
      ++rays_.size;
      places_.set(i, place);
      rays_.origin.set(i, feeler.origin);
      rays_.min_depth[i] = kShadowGap;
      rays_.hidden_bit[i] = kHiddenFromShadow;
      media_[i] = feeler.medium;
      lights_[i] = feeler.light;
      targets_[i] = target;
      if (rays_.size < kRaysAtOnce) continue;
      send();
      if (Interrupt::asked()) return;
    }
  }
  if (rays_.size > 0) send();
}

void AreaShadow::send() {
  HWY_DYNAMIC_DISPATCH(aim_at_places)(places_, aimed_, rays_);
  std::array<Rgb, kRaysAtOnce> shares;
  const std::size_t count = rays_.size;
  shadow_.passing(rays_, std::span(media_).first(count), std::span(lights_).first(count),
                  std::span(shares).first(count));
  for (std::size_t i = 0; i < count; ++i) shares_[targets_[i]] = shares[i];
  ray_count_ += count;
  rays_.size = 0;
  aimed_ = 0;
}

void AreaShadow::look_at(const Region& region, int level) {
  Grid& grid = grids_[region.grid];
  const auto corners = region.rectangle.corners();
  std::array<Rgb, 4> shares;
  std::array<Rgb, 4> colors;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    shares[i] = shares_[grid.first_point + number_of(grid, corners[i][0], corners[i][1])];
  }
  const auto differs = [&] {
    if (std::ranges::all_of(shares, [&](const Rgb& share) { return share == shares[0]; })) return false;
    for (std::size_t i = 0; i < corners.size(); ++i) colors[i] = grid.arriving * shares[i];
    return differ(colors);
  };
  if (region.rectangle.has_quarters() && (level < grid.light->adaptive || differs())) {
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
#endif
