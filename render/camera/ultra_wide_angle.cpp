#include "render/camera/projection.h"
#include "render/lanes/math.h"

namespace firstlight::render {

/// Angles from the direction grow evenly across the picture, and by the shape of the picture upwards.
ProjectionPtr projection::make_ultra_wide_angle(const Camera& camera) {
  const CameraAxes axes(camera);
  const double width = camera.angle * kRadiansPerDegree;
  const double height = camera.angle * (axes.height / axes.width) * kRadiansPerDegree;
  return from_one_place(
      camera,
      [at = camera.location, axes, width, height](double across, double upwards) -> std::optional<ProjectedRay> {
        const double x = across * width;
        const double y = upwards * height;
        return ProjectedRay{at,
                            axes.right * steady::sine(x) + axes.up * steady::sine(y) +
                                axes.direction * (steady::cosine(x) * steady::cosine(y)),
                            x, y};
      });
}

}  // namespace firstlight::render
