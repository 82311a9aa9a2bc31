#pragma once

#include "render/film/film.h"
#include "render/scene/scene.h"

#include <string>

namespace firstlight::app {

/// The numbers in a picture file.
struct FileNumbers {
  int bits = 8;        ///< per channel: 8 or 16
  double gamma = 0.0;  ///< they are light ^ (1 / gamma); 0: on the sRGB curve
};

/// Writes the film as it is now, holes between its samples filled, in the format that the path's extension names. Files
/// of linear light have numbers of their own. Empty, or why it failed.
std::string write_film(const std::string& path, const render::Film& film, const render::Settings& settings,
                       const FileNumbers& numbers = {});

/// Whether a file can be made there: its folder exists and may be written to. Empty, or what is wrong.
std::string check_writable(const std::string& name);

}  // namespace firstlight::app
