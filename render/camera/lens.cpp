#include "render/camera/lens.h"

#include "render/math/place_jitter.h"

#include <utility>

namespace firstlight::render {
namespace {

constexpr int kParts = 16;  ///< of a pixel, in which samples lie, in both directions

// Places as POV-Ray counts them when it asks for chance: the middle of the first pixel is (0, 0).
constexpr double kMiddle = 0.5;

int whole(double x) { return static_cast<int>(x); }

Vec3 sideways(const Camera& camera) { return unit(camera.up.cross(camera.direction)); }
Vec3 upwards(const Camera& camera) { return unit(camera.direction.cross(sideways(camera))); }

double within_pixel(std::uint32_t part) { return (2 * (part % kParts) + 1) / (2.0 * kParts) - 0.5; }

}  // namespace

Lens::Lens(const Camera& camera, LensGrid grid)
    : grid_(std::move(grid)),
      middle_(camera.location),
      right_(sideways(camera) * (0.5 * camera.blur.aperture)),
      up_(upwards(camera) * (0.5 * camera.blur.aperture)),
      focal_share_(camera.blur.focal_distance / camera.direction.length()) {}

LensSample Lens::moved(const LensSample& sample) const {
  const double x = sample.x - kMiddle;
  const double y = sample.y - kMiddle;
  const auto seed = static_cast<std::uint32_t>(whole(x * 313.0 + 11.0) + whole(y * 311.0 + 17.0));
  double dx = within_pixel(shuffled(seed + sample.number));
  double dy = within_pixel(shuffled(seed + sample.number + 1));
  const PlaceJitter jitter = place_jitter(dx, dy);
  dx += (jitter.x - 0.5) / kParts;
  dy += (jitter.y - 0.5) / kParts;
  return {x + dx + kMiddle, y + dy + kMiddle, sample.number};
}

void Lens::bend(const LensSample& sample, std::size_t i, CameraRays& rays) const {
  const PlaceJitter jitter = place_jitter(sample.x, sample.y - 1.0);
  const LensPoint& point = grid_.points[sample.number];
  const Vec3 offset = right_ * (point.x + jitter.x * (2.0 * grid_.most_jitter)) -
                      up_ * (point.y + jitter.y * (2.0 * grid_.most_jitter));
  rays.origin.set(i, middle_ + offset);
  rays.direction.set(i, rays.direction.vector(i) * focal_share_ - offset);
}

Box3 ray_origins(const Camera& camera) {
  if (!camera.blur.shows()) return make_projection(camera)->origins();
  constexpr double kFarthest = 1.0;  // half the side of the grid, and the jitter of a single sample
  const Vec3 right = sideways(camera) * (0.5 * camera.blur.aperture * kFarthest);
  const Vec3 up = upwards(camera) * (0.5 * camera.blur.aperture * kFarthest);
  Box3 box;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-1.0, 1.0}) box.extendBy(camera.location + right * a + up * b);
  }
  return box;
}

}  // namespace firstlight::render
