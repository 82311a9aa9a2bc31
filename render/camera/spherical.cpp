#include "render/camera/projection.h"
#include "render/lanes/math.h"

namespace firstlight::render {
namespace {

/// `v` turned about `axis`, of unit length, by Rodrigues' formula.
Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
  const double cosine = steady::cosine(angle);
  return v * cosine + axis.cross(v) * steady::sine(angle) + axis * (axis.dot(v) * (1.0 - cosine));
}

}  // namespace

/// Longitude across the picture, latitude upwards.
ProjectionPtr projection::make_spherical(const Camera& camera) {
  const double width = camera.horizontal_angle * kRadiansPerDegree;
  const double height = camera.vertical_angle * kRadiansPerDegree;
  return from_one_place(
      camera,
      [at = camera.location, direction = camera.direction, right = unit(camera.right), up = unit(camera.up), width,
       height](double across, double upwards) -> std::optional<ProjectedRay> {
        const double longitude = across * width;
        const double latitude = upwards * height;
        return ProjectedRay{at, turned(turned(direction, right, -latitude), up, longitude), longitude, latitude};
      });
}

}  // namespace firstlight::render
