#pragma once

#include "render/film/film.h"
#include "render/image/row_encoder.h"
#include "render/scene/scene.h"

#include <string>

namespace firstlight::app {

/// How the picture is written, as far as its format can.
struct FileForm {
  render::FileNumbers numbers;
  int quality = 0;    ///< as PictureRows has it
  bool runs = false;  ///< the same
};

/// Writes the film as it is now, holes between its samples filled, in the format that the path's extension names. Files
/// of linear light have numbers of their own, multiplied by alpha. Empty, or why it failed.
std::string write_film(const std::string& path, const render::Film& film, const render::Settings& settings,
                       FileForm form = {});

/// Whether a file can be made there: its folder exists and may be written to. Empty, or what is wrong.
std::string check_writable(const std::string& name);

}  // namespace firstlight::app
