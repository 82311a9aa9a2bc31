#include "render/camera/camera_kind.h"

#include <array>
#include <cstddef>

namespace firstlight::render {

Feature feature_of(CameraKind kind) {
  static constexpr auto kFeatures = std::to_array<Feature>({
#define CAMERA(kind, word, maker) Feature::camera_##kind,
#include "render/camera/cameras.def"
#undef CAMERA
  });
  return kFeatures[static_cast<std::size_t>(kind)];
}

}  // namespace firstlight::render
