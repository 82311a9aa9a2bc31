#pragma once

#include "render/feature/feature.h"

#include <cstdint>

namespace firstlight::render {

/// How places of the picture become rays: one row a kind in cameras.def.
enum class CameraKind : std::uint8_t {
#define CAMERA(kind, word, maker) kind,
#include "render/camera/cameras.def"
#undef CAMERA
};

/// The feature that a camera of the kind asks for.
Feature feature_of(CameraKind kind);

}  // namespace firstlight::render
