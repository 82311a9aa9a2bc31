#pragma once

#include "render/camera/camera.h"
#include "render/camera/lens_grid.h"
#include "render/camera/projection.h"
#include "render/math/vec.h"

#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// One of the rays through a place of the picture, of which focal blur takes the mean.
struct LensSample {
  double x;  ///< picture coordinates, see PicturePlaces::add
  double y;
  std::uint32_t number;  ///< among the samples of the place
};

/// A lens of an aperture: rays through a place begin at its points, and meet at the focal distance.
///
/// Source   POV-Ray 3.7: places and points move by chance that hangs on the place alone.
/// Threads  Immutable.
class Lens {
 public:
  Lens(const Camera& camera, LensGrid grid);

  /// A place of the picture moved within its pixel, another way for each number.
  LensSample moved(const LensSample& sample) const;
  /// Ray `i` of a pinhole through sample.x, sample.y becomes that of the lens. Pre: sample.number is a point of the grid.
  void bend(const LensSample& sample, std::size_t i, CameraRays& rays) const;

 private:
  LensGrid grid_;
  Vec3 middle_;
  Vec3 right_;  ///< from the middle to the edge
  Vec3 up_;
  double focal_share_;  ///< the focal distance in lengths of the camera's direction
};

/// A box about the origins of all rays of a camera, with its lens if it has one.
Box3 ray_origins(const Camera& camera);

}  // namespace firstlight::render
