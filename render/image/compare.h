#pragma once

#include "render/image/image_io.h"

#include <optional>
#include <string>

namespace firstlight::render {

/// How far two pictures are apart.
struct Difference {
  double share_within = 1.0;  ///< of the pixels, 0 to 1: no channel differs by more than the tolerance, nor alpha
  int worst = 0;              ///< largest difference of a channel or of alpha, of 255
  int worst_x = 0;            ///< the first pixel, row by row, where it is
  int worst_y = 0;
  double psnr = 0.0;  ///< dB over all channels but alpha; infinite when the pictures are equal
};

/// Nothing when the sizes differ.
std::optional<Difference> compare(const Picture& a, const Picture& b, int tolerance);

/// "98.53 % of pixels within 2/255, worst 31 at (12, 80), 41.2 dB"
std::string summary(const Difference& difference, int tolerance);

}  // namespace firstlight::render
