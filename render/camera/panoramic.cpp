#include "render/camera/projection.h"
#include "render/lanes/math.h"

#include <numbers>

namespace firstlight::render {
namespace {

constexpr double kUpright = 1e-10;  ///< radians from straight up, within which a tangent is kSteepest
constexpr double kSteepest = 2e10;

}  // namespace

/// Half a turn from left to right and from bottom to top, on a cylinder; straight up and down are the edges.
/// Source   Graphics Gems III, by POV-Ray's manual.
ProjectionPtr projection::make_panoramic(const Camera& camera) {
  return from_one_place(camera,
                        [at = camera.location, direction = camera.direction, right = camera.right, up = camera.up](
                            double across, double upwards) -> std::optional<ProjectedRay> {
                          const double longitude = (1.0 - (across + 0.5)) * std::numbers::pi;
                          const double latitude = std::numbers::pi * upwards;
                          const double rise = std::abs(std::numbers::pi / 2 - std::abs(latitude)) < kUpright
                                                  ? std::copysign(kSteepest, latitude)
                                                  : steady::tangent(latitude);
                          return ProjectedRay{
                              at, right * steady::cosine(longitude) + up * rise + direction * steady::sine(longitude),
                              longitude, latitude};
                        });
}

}  // namespace firstlight::render
