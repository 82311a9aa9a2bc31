#pragma once

#include "app/options.h"
#include "app/progress.h"
#include "render/scene/front_end.h"

namespace firstlight::app {

/// Reads the scene and shows on the error stream what the front end has to say about it.
render::LoadResult load_scene(const Options& options, const render::FrontEnd& front_end, ProgressLine& line);

}  // namespace firstlight::app
