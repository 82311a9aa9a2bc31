#pragma once

#include "render/film/film.h"
#include "render/scene/scene.h"

#include <string>

namespace firstlight::app {

/// Writes the film as it is now, holes between its samples filled, in the format that the path's extension names.
/// Empty, or why it failed.
std::string write_film(const std::string& path, const render::Film& film, const render::Settings& settings);

/// Whether a file can be made there: its folder exists and may be written to. Empty, or what is wrong.
std::string check_writable(const std::string& name);

}  // namespace firstlight::app
