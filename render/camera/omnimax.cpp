#include "render/camera/round.h"
#include "render/lanes/math.h"

#include <algorithm>

namespace firstlight::render {
namespace {

constexpr double kWidest = 1.283458;  ///< shape of what the dome shows
constexpr double kLowest = -1.0;      ///< tangent of 135 degrees

}  // namespace

/// A fisheye for domes: angles from the direction grow by a polynomial, and what lies more than 45 degrees below it is
/// left out. Wide pictures have the disc's lower part cut off.
ProjectionPtr projection::make_omnimax(const Camera& camera) {
  const CameraAxes axes(camera);
  const double shape = axes.width / axes.height;
  return from_one_place(
      camera, [at = camera.location, axes, shape](double across, double upwards) -> std::optional<ProjectedRay> {
        double x = 2.0 * across;
        double y = 2.0 * upwards;
        if (shape > kWidest) x *= shape / kWidest;
        if (shape > 1.0) {
          y = (y - 1.0) / std::min(shape, kWidest) + 1.0;
        } else {
          y /= shape;
        }
        const double radius = std::sqrt(x * x + y * y);
        if (radius > 1.0) return std::nullopt;
        const double cube = radius * radius * radius;
        const double off_axis = 1.411269 * radius - 0.09439 * cube + 0.25674 * cube * radius * radius;
        const double around = angle_on_disc(x, y, radius);
        if (steady::sine(around) * steady::sine(off_axis) < kLowest * steady::cosine(off_axis)) return std::nullopt;
        return ray_off_axis(at, axes, around, off_axis);
      });
}

}  // namespace firstlight::render
