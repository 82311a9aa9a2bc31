#pragma once

#include "app/options.h"
#include "app/progress.h"
#include "render/scene/front_end.h"

#include <atomic>

namespace firstlight::app {

/// Reads the scene and shows on the error stream what the front end has to say about it. It ends soon when `stop`
/// becomes true.
render::LoadResult load_scene(const Options& options, const render::FrontEnd& front_end, ProgressLine& line,
                              const std::atomic<bool>& stop);

}  // namespace firstlight::app
