#include "render/trace/primary.h"

#include <algorithm>

namespace firstlight::render {

std::uint32_t medium_at(const Scene& scene, MediumTable& media, const Vec3& point) {
  std::uint32_t medium = MediumTable::kOutside;
  for (const Solid& solid : scene.solids) {
    if (!media.contains(medium, solid.matter) && solid.inside(point)) medium = media.entered(medium, solid.matter);
  }
  return medium;
}

PrimaryTiles::PrimaryTiles(const Scene& scene, MediumTable& media, int width, int height)
    : scene_(scene),
      medium_(medium_at(scene, media, scene.camera.location)),
      width_(width),
      height_(height),
      columns_(static_cast<std::uint32_t>((width + kTileSize - 1) / kTileSize)),
      rows_(static_cast<std::uint32_t>((height + kTileSize - 1) / kTileSize)) {}

void PrimaryTiles::fill(std::uint32_t tile, PrimaryBatch& batch) const {
  batch.tasks.clear();
  batch.rays.clear();
  const int x0 = static_cast<int>(tile % columns_) * kTileSize;
  const int y0 = static_cast<int>(tile / columns_) * kTileSize;
  for (int y = y0; y < std::min(y0 + kTileSize, height_); ++y) {
    for (int x = x0; x < std::min(x0 + kTileSize, width_); ++x) {
      const Ray ray = primary_ray(scene_.camera, x + 0.5, y + 0.5, width_, height_);
      RayTask task;
      task.origin = ray.origin;
      task.radiance.direction = PackedDirection(ray.direction);
      task.radiance.set_weight(Rgb(1.0f));
      task.sample = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width_) + static_cast<std::uint32_t>(x);
      task.path = task.sample;
      task.medium = medium_;
      batch.tasks.push_back(task);
      batch.rays.push_back(ray);
    }
  }
}

}  // namespace firstlight::render
