#pragma once

#include "render/image/picture.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace firstlight::render {

/// A picture whose rows are made when they are asked for, so that all of them need not be in memory at once.
struct PictureRows {
  int width = 0;
  int height = 0;
  /// Red green blue of each pixel of a row, counted from the top; asked for once each, in any order.
  std::function<void(int y, std::span<std::uint8_t> rgb)> make;
  int channel_bytes = 1;  ///< 2: numbers up to 65535, the upper byte first
  double gamma = 0.0;     ///< numbers are light ^ (1 / gamma); 0: on the sRGB curve

  std::size_t row_bytes() const { return std::size_t{3} * static_cast<std::size_t>(channel_bytes * width); }
};

/// Pre: the picture outlives what is returned.
PictureRows rows_of(const Picture& picture);
PictureRows rows_of(int width, int height, std::span<const std::uint8_t> rgb);
/// Red green blue of all pixels, rows from the top.
std::vector<std::uint8_t> whole(const PictureRows& rows);

}  // namespace firstlight::render
