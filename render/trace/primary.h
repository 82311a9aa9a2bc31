#pragma once

#include "render/camera/projection.h"
#include "render/trace/ray_task.h"
#include "render/trace/start_medium.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace firstlight::render {

class CompiledNormal;
class Lens;
class MediumTable;
struct FocalBlur;
struct Scene;

/// A place of the picture that is to light a sample of the film, in picture coordinates (see PicturePlaces::add).
struct PrimaryPlace {
  double x;
  double y;
  std::uint32_t sample;
  std::uint32_t number = 0;  ///< of the ray among those of the place, where there is focal blur
};

/// Primary rays and their tasks, place by place. The rays are kept beside the tasks, which have no directions, in full
/// precision: a scene's surfaces often lie exactly on the rows and columns of pixels.
struct PrimaryBatch {
  std::vector<RayTask> tasks;
  std::vector<Ray> rays;
  std::vector<std::uint32_t> dark;  ///< samples of places that no ray leads through: they are black, and complete
  /// Places that several rays share, an equal part of their light each.
  struct Shared {
    RayTask ray;  ///< any one of them
    int rays;
  };
  std::vector<Shared> shared;

  void clear() {
    shared.clear();
    tasks.clear();
    rays.clear();
    dark.clear();
  }
};

/// Makes primary rays.
///
/// Threads  append() may be called from any thread.
class PrimaryRays {
 public:
  /// Pre: all outlive it, the view's camera too.
  PrimaryRays(const Scene& scene, MediumTable& media, const View& view);
  ~PrimaryRays();

  /// A ray that has not been made, as schemes see it: without a direction, of sample 0, from the camera's location.
  const RayTask& unmade() const { return unmade_; }

  int width() const { return view_.width; }
  int height() const { return view_.height; }
  /// Null: a place needs one ray.
  const FocalBlur* blur() const;
  /// Appends the rays through the places, in their order.
  void append(std::span<const PrimaryPlace> places, PrimaryBatch& batch) const;

 private:
  void append_block(std::span<const PrimaryPlace> places, PrimaryBatch& batch) const;
  /// The same where places have several rays.
  void append_shared(const PicturePlaces& in_picture, std::span<const PrimaryPlace> places, PrimaryBatch& batch) const;
  /// Pre: the rays' directions have unit length.
  RayTask& append_ray(const CameraRays& rays, std::size_t i, std::uint32_t sample, PrimaryBatch& batch) const;
  /// Turns the rays by the camera's normal.
  void tilt(std::size_t count, CameraRays& rays) const;

  const View view_;
  ProjectionPtr projection_;
  StartMedium medium_;
  std::unique_ptr<const Lens> lens_;              ///< null: none
  std::unique_ptr<const CompiledNormal> normal_;  ///< null: none
  RayTask unmade_;
};

/// The pixels of a picture cut into tiles, to be traced one after the other: from a coarse grid of pixels over the
/// whole picture to the finest, so that a preview can fill the holes between them early, or square by square.
class PrimaryTiles {
 public:
  enum class Order { coarse_to_fine, square_by_square };

  /// Pixels on each side of a tile, in steps of its grid.
  static constexpr int kTileSize = 16;

  /// `offset`: of a pixel's sample from its upper left corner, in pixels, the same to the right and down.
  PrimaryTiles(int width, int height, double offset, Order order);

  std::uint32_t count() const { return count_; }
  /// How many tiles, from the first, make up the coarsest grid.
  std::uint32_t coarse_count() const { return levels_.front().tiles(); }
  /// Pixels between the points of the grid that a tile is of. Pre: tile < count().
  int stride_of(std::uint32_t tile) const;
  /// The sample of the tile's upper left pixel. Pre: as above.
  std::uint32_t corner_of(std::uint32_t tile) const;
  /// Appends the rays of the tile's pixels, row by row. Pre: tile < count(), sizes as given above.
  void fill(std::uint32_t tile, const PrimaryRays& rays, PrimaryBatch& batch) const;
  /// Appends the samples of those rays. Pre: as for fill().
  void append_samples(std::uint32_t tile, std::vector<std::uint32_t>& samples) const;

 private:
  struct Level {
    int stride;  ///< pixels between points
    bool first;  ///< else the points of the level before are left out
    std::uint32_t columns;
    std::uint32_t rows;
    std::uint32_t tiles() const { return columns * rows; }
  };
  struct Place {
    const Level* level;
    int x;  ///< of the upper left pixel
    int y;
  };
  Place place_of(std::uint32_t tile) const;
  std::uint32_t sample_at(int x, int y) const {
    return static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width_) + static_cast<std::uint32_t>(x);
  }
  /// Calls visit(x, y, sample) for each pixel of the tile.
  template <class Visit>
  void for_each_pixel(std::uint32_t tile, const Visit& visit) const;

  int width_;
  int height_;
  double offset_;
  std::vector<Level> levels_;
  std::uint32_t count_ = 0;
};

}  // namespace firstlight::render
