#include "render/camera/projection.h"

namespace firstlight::render {

/// Parallel rays, from the places of a picture that `right` and `up` span around the location.
ProjectionPtr projection::make_orthographic(const Camera& camera) {
  return from_many_places(camera, camera.right, camera.up,
                          [at = camera.location, direction = camera.direction, right = camera.right, up = camera.up](
                              double across, double upwards) -> std::optional<ProjectedRay> {
                            return ProjectedRay{at + right * across + up * upwards, direction, across, upwards};
                          });
}

}  // namespace firstlight::render
