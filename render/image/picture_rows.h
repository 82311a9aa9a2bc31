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
  /// The channels of each pixel of a row, counted from the top; asked for once each, in the order in which they stand
  /// in the file.
  std::function<void(int y, std::span<std::uint8_t> row)> make;
  int channels =
      3;  ///< 1: grey; 2: grey alpha; 3: red green blue; 4: red green blue alpha, colours not multiplied by it
  int channel_bytes = 1;  ///< 2: the upper byte first
  int bits = 8;           ///< of a number, that count
  double gamma = 0.0;     ///< numbers are light ^ (1 / gamma); 0: on the sRGB curve
  int quality = 0;        ///< of a format that loses some: 1 to 100; 0: the usual one
  bool runs = false;      ///< shorter, where equal pixels follow each other, in a format that knows both forms

  bool has_alpha() const { return channels == 2 || channels == 4; }
  std::size_t pixel_bytes() const { return static_cast<std::size_t>(channels * channel_bytes); }
  std::size_t row_bytes() const { return pixel_bytes() * static_cast<std::size_t>(width); }
};

/// Pre: the picture outlives what is returned.
PictureRows rows_of(const Picture& picture);
PictureRows rows_of(int width, int height, std::span<const std::uint8_t> rgb);
/// The channels of all pixels, rows from the top.
std::vector<std::uint8_t> whole(const PictureRows& rows);

}  // namespace firstlight::render
