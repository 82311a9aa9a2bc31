#pragma once

#include "render/image/encode.h"
#include "render/scene/scene.h"

namespace firstlight::render {

/// How the finished picture of a scene with these settings is written to a file.
Encoding file_encoding(const Settings& settings);

}  // namespace firstlight::render
