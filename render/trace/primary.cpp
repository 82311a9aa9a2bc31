#include "render/trace/primary.h"

#include "render/math/pixel_grid.h"

#include <algorithm>

namespace firstlight::render {

std::uint32_t medium_at(const Scene& scene, MediumTable& media, const Vec3& point) {
  std::uint32_t medium = MediumTable::kOutside;
  for (const Solid& solid : scene.solids) {
    if (!media.contains(medium, solid.matter) && solid.holds_start(point)) medium = media.entered(medium, solid.matter);
  }
  return medium;
}

PrimaryRays::PrimaryRays(const Scene& scene, MediumTable& media, int width, int height)
    : scene_(scene), width_(width), height_(height) {
  unmade_.origin = scene.camera.location;
  unmade_.set_weight(Rgb(1.0f), 1.0f);
  unmade_.medium = medium_at(scene, media, scene.camera.location);
}

void PrimaryRays::append(double x, double y, std::uint32_t sample, PrimaryBatch& batch) const {
  const Ray ray = primary_ray(scene_.camera, x, y, width_, height_);
  RayTask& task = batch.tasks.emplace_back(unmade_);
  task.origin = ray.origin;
  task.sample = sample;
  batch.rays.push_back(ray);
}

PrimaryTiles::PrimaryTiles(int width, int height, double offset, Order order)
    : width_(width), height_(height), offset_(offset) {
  for (int stride = order == Order::coarse_to_fine ? kCoarsestGrid : 1; stride > 0; stride /= 2) {
    const auto tiles_across = [stride](int pixels) {
      const int side = kTileSize * stride;
      return static_cast<std::uint32_t>((pixels + side - 1) / side);
    };
    levels_.push_back({stride, levels_.empty(), tiles_across(width), tiles_across(height)});
    count_ += levels_.back().tiles();
  }
}

PrimaryTiles::Place PrimaryTiles::place_of(std::uint32_t tile) const {
  auto level = levels_.begin();
  for (; tile >= level->tiles(); ++level) tile -= level->tiles();
  const int side = kTileSize * level->stride;
  return {&*level, static_cast<int>(tile % level->columns) * side, static_cast<int>(tile / level->columns) * side};
}

int PrimaryTiles::stride_of(std::uint32_t tile) const { return place_of(tile).level->stride; }

std::uint32_t PrimaryTiles::corner_of(std::uint32_t tile) const {
  const Place place = place_of(tile);
  return sample_at(place.x, place.y);
}

template <class Visit>
void PrimaryTiles::for_each_pixel(std::uint32_t tile, const Visit& visit) const {
  const auto [level, x0, y0] = place_of(tile);
  const int stride = level->stride;
  const int side = kTileSize * stride;
  // A square begins on the grid before, of whose points every second one of every second row is on it.
  for (int y = y0; y < std::min(y0 + side, height_); y += stride) {
    const bool has_points_before = !level->first && ((y - y0) & stride) == 0;
    const int first = has_points_before ? x0 + stride : x0;
    for (int x = first; x < std::min(x0 + side, width_); x += has_points_before ? 2 * stride : stride) {
      visit(x, y, sample_at(x, y));
    }
  }
}

void PrimaryTiles::fill(std::uint32_t tile, const PrimaryRays& rays, PrimaryBatch& batch) const {
  for_each_pixel(tile,
                 [&](int x, int y, std::uint32_t sample) { rays.append(x + offset_, y + offset_, sample, batch); });
}

void PrimaryTiles::append_samples(std::uint32_t tile, std::vector<std::uint32_t>& samples) const {
  for_each_pixel(tile, [&](int, int, std::uint32_t sample) { samples.push_back(sample); });
}

}  // namespace firstlight::render
