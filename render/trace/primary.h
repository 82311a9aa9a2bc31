#pragma once

#include "render/scene/scene.h"
#include "render/trace/medium_table.h"
#include "render/trace/ray_task.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// Primary rays and their tasks, place by place. The rays are kept beside the tasks in full precision: a scene's
/// surfaces often lie exactly on the rows and columns of pixels.
struct PrimaryBatch {
  std::vector<RayTask> tasks;
  std::vector<Ray> rays;
};

/// What a ray that begins at `point` is inside of.
std::uint32_t medium_at(const Scene& scene, MediumTable& media, const Vec3& point);

/// The picture cut into squares of kTileSize pixels, whose primary rays are made on demand and never queued.
class PrimaryTiles {
 public:
  static constexpr int kTileSize = 16;

  PrimaryTiles(const Scene& scene, MediumTable& media, int width, int height);

  std::uint32_t count() const { return columns_ * rows_; }
  /// Replaces `batch` by the primary rays of a tile, pixel by pixel, row by row. Pre: tile < count().
  void fill(std::uint32_t tile, PrimaryBatch& batch) const;

 private:
  const Scene& scene_;
  std::uint32_t medium_;
  int width_;
  int height_;
  std::uint32_t columns_;
  std::uint32_t rows_;
};

}  // namespace firstlight::render
