#pragma once

#include <cstdint>

namespace firstlight::render {

/// Kinds of a light's beam: one row each in lights.def.
enum class LightKind : std::uint8_t {
#define LIGHT(kind, beam, parallel, radius, falloff) kind,
#include "render/light/lights.def"
#undef LIGHT
};

}  // namespace firstlight::render
