#pragma once

#include "app/options.h"
#include "render/scene/front_end.h"

#include <atomic>
#include <string>

namespace firstlight::app {

/// `--parse-only`: reads the scene and prints what is in it and what cannot be rendered, as text or JSON. The process's
/// exit code: 0 when the scene could be read. `stop` becomes true when the user wants an end.
int parse_command(const Options& options, const std::atomic<bool>& stop);

/// `{"scene", "objects", "lights", "textures", "keywords": {word: count}, "unrendered": [{"feature", "file", "line",
/// "column"}]}`
std::string to_json(const std::string& scene, const render::SceneSummary& summary);

}  // namespace firstlight::app
