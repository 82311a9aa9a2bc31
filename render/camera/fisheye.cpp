#include "render/camera/round.h"

namespace firstlight::render {

/// A disc in which the distance from the middle is the angle from the direction. Beyond it there is nothing.
ProjectionPtr projection::make_fisheye(const Camera& camera) {
  const CameraAxes axes(camera);
  const double half_angle = 0.5 * camera.angle * kRadiansPerDegree;
  return from_one_place(
      camera, [at = camera.location, axes, half_angle](double across, double upwards) -> std::optional<ProjectedRay> {
        const double x = 2.0 * across * axes.width;
        const double y = 2.0 * upwards * axes.height;
        const double radius = std::sqrt(x * x + y * y);
        if (radius > 1.0) return std::nullopt;
        return ray_off_axis(at, axes, angle_on_disc(x, y, radius), radius * half_angle);
      });
}

}  // namespace firstlight::render
