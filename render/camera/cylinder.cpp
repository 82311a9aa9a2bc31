// Pictures on a cylinder around the location. Angles are even around it, lengths along it.

#include "render/camera/projection.h"
#include "render/lanes/math.h"

namespace firstlight::render {

ProjectionPtr projection::make_cylinder_1(const Camera& camera) {
  const CameraAxes axes(camera);
  const double width = camera.angle * kRadiansPerDegree;
  return from_one_place(
      camera, [at = camera.location, axes, width](double across, double upwards) -> std::optional<ProjectedRay> {
        const double x = across * width;
        const double y = upwards * axes.height;
        return ProjectedRay{at, axes.right * steady::sine(x) + axes.up * y + axes.direction * steady::cosine(x), x, y};
      });
}

ProjectionPtr projection::make_cylinder_2(const Camera& camera) {
  const CameraAxes axes(camera);
  const double height = camera.angle * kRadiansPerDegree;
  return from_one_place(
      camera, [at = camera.location, axes, height](double across, double upwards) -> std::optional<ProjectedRay> {
        const double x = across * axes.width;
        const double y = upwards * height;
        return ProjectedRay{at, axes.right * x + axes.up * steady::sine(y) + axes.direction * steady::cosine(y), x, y};
      });
}

ProjectionPtr projection::make_cylinder_3(const Camera& camera) {
  const CameraAxes axes(camera);
  const double width = camera.angle * kRadiansPerDegree;
  return from_many_places(
      camera, camera.up, Vec3(0.0),
      [at = camera.location, axes, width](double across, double upwards) -> std::optional<ProjectedRay> {
        const double x = across * width;
        const double y = upwards * axes.height;
        return ProjectedRay{at + axes.up * y, axes.right * steady::sine(x) + axes.direction * steady::cosine(x), x, y};
      });
}

ProjectionPtr projection::make_cylinder_4(const Camera& camera) {
  const CameraAxes axes(camera);
  const double height = camera.angle * kRadiansPerDegree;
  return from_many_places(
      camera, camera.right, Vec3(0.0),
      [at = camera.location, axes, height](double across, double upwards) -> std::optional<ProjectedRay> {
        const double x = across * axes.width;
        const double y = upwards * height;
        return ProjectedRay{at + axes.right * x, axes.up * steady::sine(y) + axes.direction * steady::cosine(y), x, y};
      });
}

}  // namespace firstlight::render
