#pragma once

#include <cstdint>

namespace firstlight::render {

/// What a light's beam is like: one row a kind in lights.def.
enum class LightKind : std::uint8_t {
#define LIGHT(kind, beam, parallel, radius, falloff) kind,
#include "render/light/lights.def"
#undef LIGHT
};

}  // namespace firstlight::render
