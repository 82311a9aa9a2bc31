#include "render/trace/primary.h"

#include "render/camera/lens.h"
#include "render/math/pixel_grid.h"
#include "render/math/scratch.h"
#include "render/math/unit_columns.h"
#include "render/scene/scene.h"
#include "render/surface/compiled_normal.h"
#include "render/surface/compiled_pigment.h"

#include <algorithm>
#include <array>
#include <utility>

namespace firstlight::render {
namespace {

LensGrid grid_of(const FocalBlur& blur, const PatternWorld& world) {
  if (!blur.bokeh) return round_lens(blur.samples);
  const CompiledPigment pigment(*blur.bokeh, world);
  return shaped_lens(blur.samples, [&](double x, double y) { return grey(pigment.color_at({x, y, 0.0}).rgb); });
}

}  // namespace

PrimaryRays::PrimaryRays(const Scene& scene, MediumTable& media, const View& view)
    : view_(view), projection_(make_projection(view.camera)), medium_(scene, media, ray_origins(view.camera)) {
  const PatternWorld world{scene.settings.noise_generator, scene.settings.number_of_waves};
  if (has_lens(view.camera)) lens_ = std::make_unique<const Lens>(view.camera, grid_of(view.camera.blur, world));
  if (view.camera.normal) {
    normal_ = std::make_unique<const CompiledNormal>(*view.camera.normal, world, /*keeps_length=*/false);
  }
  unmade_.origin = view.camera.location;
  unmade_.set_weight(Rgb(1.0f), 1.0f);
  unmade_.medium = medium_.of(unmade_.origin);
}

PrimaryRays::~PrimaryRays() = default;

const FocalBlur* PrimaryRays::blur() const { return lens_ ? &view_.camera.blur : nullptr; }

void PrimaryRays::append(std::span<const PrimaryPlace> places, PrimaryBatch& batch) const {
  for (std::size_t first = 0; first < places.size(); first += kRaysAtOnce) {
    append_block(places.subspan(first, std::min(places.size() - first, kRaysAtOnce)), batch);
  }
}

void PrimaryRays::append_block(std::span<const PrimaryPlace> places, PrimaryBatch& batch) const {
  PicturePlaces in_picture;
  std::array<LensSample, kRaysAtOnce> samples;
  for (std::size_t i = 0; i < places.size(); ++i) {
    samples[i] = {places[i].x, places[i].y, places[i].number};
    if (lens_) samples[i] = lens_->moved(samples[i]);
    in_picture.add(samples[i].x, samples[i].y, view_.width, view_.height);
  }
  if (projection_->rays_per_place() > 1) return append_shared(in_picture, places, batch);
  CameraRays rays;
  projection_->project(in_picture, rays);
  if (lens_) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      if ((rays.missing >> i & 1u) == 0) lens_->bend(samples[i], i, rays);
    }
  }
  if (normal_) tilt(places.size(), rays);
  make_unit(rays.direction, places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if ((rays.missing >> i & 1u) != 0) {
      batch.dark.push_back(places[i].sample);
      continue;
    }
    append_ray(rays, i, places[i].sample, batch);
  }
}

RayTask& PrimaryRays::append_ray(const CameraRays& rays, std::size_t i, std::uint32_t sample,
                                 PrimaryBatch& batch) const {
  const Ray& ray = batch.rays.emplace_back(Ray{rays.origin.vector(i), rays.direction.vector(i)});
  RayTask& task = batch.tasks.emplace_back(unmade_);
  task.sample = sample;
  if (ray.origin != unmade_.origin) {
    task.origin = ray.origin;
    task.medium = medium_.of(ray.origin);
  }
  return task;
}

void PrimaryRays::append_shared(const PicturePlaces& in_picture, std::span<const PrimaryPlace> places,
                                PrimaryBatch& batch) const {
  std::array<int, kRaysAtOnce> counts{};
  std::vector<CameraRays> all(static_cast<std::size_t>(projection_->rays_per_place()));
  for (std::size_t number = 0; number < all.size(); ++number) {
    projection_->project_further(static_cast<int>(number), in_picture, all[number]);
    if (normal_) tilt(places.size(), all[number]);
    make_unit(all[number].direction, places.size());
    for (std::size_t i = 0; i < places.size(); ++i) counts[i] += (all[number].missing >> i & 1u) != 0 ? 0 : 1;
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (counts[i] == 0) batch.dark.push_back(places[i].sample);
    for (const CameraRays& rays : all) {
      if ((rays.missing >> i & 1u) != 0) continue;
      // Pruning goes by a ray's way, not by how many share the place.
      append_ray(rays, i, places[i].sample, batch).set_weight(Rgb(1.0f / static_cast<float>(counts[i])), 1.0f);
    }
    if (counts[i] > 1) batch.shared.push_back({batch.tasks.back(), counts[i]});
  }
}

// The pattern lies in the projection's own coordinates, at z = 0, and the directions are its normals. [POV-Ray 3.7]
void PrimaryRays::tilt(std::size_t count, CameraRays& rays) const {
  const Scratch<SurfacePoints> points;
  points->on_surface = false;
  points->size = count;
  for (std::size_t i = 0; i < count; ++i) {
    const bool missing = (rays.missing >> i & 1u) != 0;
    if (missing) rays.direction.set(i, Vec3(0.0, 0.0, 1.0));
    const Vec3 direction = unit(rays.direction.vector(i));
    rays.direction.set(i, direction);
    points->at.set(i, missing ? Vec3(0.0) : Vec3(rays.x[i], rays.y[i], 0.0));
    points->normal.set(i, direction);
    points->tilted.set(i, direction);
    points->direction.set(i, direction);
    points->uv.set(i, Vec2(0.0));
  }
  normal_->tilt(*points, nullptr, rays.direction);
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
  std::array<PrimaryPlace, kRaysAtOnce> places;
  std::size_t count = 0;
  const auto send = [&] { rays.append(std::span(places).first(std::exchange(count, 0)), batch); };
  for_each_pixel(tile, [&](int x, int y, std::uint32_t sample) {
    places[count++] = {x + offset_, y + offset_, sample};
    if (count == places.size()) send();
  });
  send();
}

void PrimaryTiles::append_samples(std::uint32_t tile, std::vector<std::uint32_t>& samples) const {
  for_each_pixel(tile, [&](int, int, std::uint32_t sample) { samples.push_back(sample); });
}

}  // namespace firstlight::render
