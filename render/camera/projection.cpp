#include "render/camera/projection.h"

#include "render/camera/camera_kind.h"

#include <array>

namespace firstlight::render {
namespace {

using Maker = ProjectionPtr (*)(const Camera& camera);

constexpr auto kMakers = std::to_array<Maker>({
#define CAMERA(kind, word, maker) projection::maker,
#include "render/camera/cameras.def"
#undef CAMERA
});

}  // namespace

ProjectionPtr make_projection(const Camera& camera) { return kMakers[static_cast<std::size_t>(camera.kind)](camera); }

std::optional<Ray> ray_through(const View& view, double x, double y) {
  PicturePlaces places;
  places.add(x, y, view.width, view.height);
  CameraRays rays;
  make_projection(view.camera)->project(places, rays);
  if (rays.missing != 0) return std::nullopt;
  return Ray{rays.origin.vector(0), unit(rays.direction.vector(0))};
}

}  // namespace firstlight::render
