#pragma once

#include "app/options.h"
#include "render/scene/scene.h"

#include <optional>

namespace firstlight::app {

/// The anti-aliasing that was asked for, with what it has to know of the scene's colours.
std::optional<render::AntialiasSettings> antialias_of(const Options& options, const render::Settings& scene);

}  // namespace firstlight::app
