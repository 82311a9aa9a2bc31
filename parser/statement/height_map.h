#pragma once

#include "render/shape/height_field.h"
#include "render/texture/image_use.h"

#include <string>

namespace firstlight::parser {

/// The heights that a picture has, into `field`. On failure `error` says why.
/// Source   POV-Ray 3.7: of pictures with a palette the index counts, of grey ones and of those with more than 8 bits
///          the brightness, of others red and green are the two halves of a number.
void read_heights(const render::ImageSource& source, int noise_generator, render::HeightFieldParameters& field,
                  std::string& error);

}  // namespace firstlight::parser
