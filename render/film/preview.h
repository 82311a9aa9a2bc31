#pragma once

#include "render/film/film.h"
#include "render/math/color.h"

#include <vector>

namespace firstlight::render {

/// The picture as it can be shown now, rows from the top: pixels whose own light is on the film as they are, the holes
/// between them filled from their nearest lit neighbours on the next coarser grid. The film's own colours once every
/// pixel is lit.
///
/// Source   Progressive sampling from coarse grids to fine, as in Painter and Sloan, "Antialiased ray tracing by
///          adaptive progressive refinement", SIGGRAPH 1989.
std::vector<Rgb> preview(const Film& film);
/// The same with what shows through.
std::vector<PixelColor> preview_with_alpha(const Film& film);

}  // namespace firstlight::render
