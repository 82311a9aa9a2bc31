#include "render/camera/projection.h"

namespace firstlight::render {

/// Through the places of a picture that `right` and `up` span around location + direction.
ProjectionPtr projection::make_perspective(const Camera& camera) {
  return from_one_place(camera,
                        [at = camera.location, direction = camera.direction, right = camera.right, up = camera.up](
                            double across, double upwards) -> std::optional<ProjectedRay> {
                          return ProjectedRay{at, direction + right * across + up * upwards, across, upwards};
                        });
}

}  // namespace firstlight::render
