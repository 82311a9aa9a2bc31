#pragma once

#include "render/image/dither.h"
#include "render/image/encode.h"
#include "render/math/pixel_color.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace firstlight::render {

/// The numbers of a picture file.
struct FileNumbers {
  int bits = 8;        ///< that count, per channel: 5 to 16
  double gamma = 0.0;  ///< they are light ^ (1 / gamma); 0: on the sRGB curve
  bool grey = false;   ///< one for each pixel, instead of red green blue
  bool alpha = false;  ///< one more for what does not show through; then the others are divided by it
  Dithering dithering = Dithering::none;

  int channels() const { return (grey ? 1 : 3) + (alpha ? 1 : 0); }
  int channel_bytes() const { return bits > 8 ? 2 : 1; }
};

/// Makes the rows of a picture file, in the order in which they stand in it.
///
/// Source  POV-Ray 3.7. Its colours are what is seen in front of black; where they are divided by an alpha that is
///         smaller than they are bright, alpha is made larger, so that highlights of clear surfaces are not lost.
class RowEncoder {
 public:
  /// Numbers of fewer bits than their bytes have fill these, and are repeated in the low bits, unless `fills` is false.
  RowEncoder(const Encoding& encoding, const FileNumbers& numbers, int width, bool fills = true);

  /// Pre: the file has no alpha; room for all bytes of the row.
  void encode(int y, std::span<const Rgb> row, std::span<std::uint8_t> bytes);
  void encode(int y, std::span<const PixelColor> row, std::span<std::uint8_t> bytes);

 private:
  /// Channels of a pixel: colours, then alpha.
  using Channels = std::array<float, 4>;

  void encode_pixel(std::size_t x, std::size_t y, const PixelColor& pixel, std::uint8_t*& to);
  Channels channels_of(const PixelColor& pixel) const;
  float decoded(float number);
  void put(float number, std::uint8_t*& to) const;

  Encoding encoding_;
  FileNumbers numbers_;
  float white_;
  int shift_ = 0;                   ///< of numbers of fewer bits than their bytes have
  std::optional<ByteTable> table_;  ///< of plain colours
  Ditherer ditherer_;
  std::vector<float> decoded_;  ///< of each number of the file, where errors are handed on; not-a-number: not known yet
};

/// Appends the channels of each pixel as light, colours multiplied by alpha. Pre: they are not grey.
void append_light(std::span<const Rgb> row, const Encoding& encoding, const FileNumbers& numbers,
                  std::vector<float>& light);
void append_light(std::span<const PixelColor> row, const Encoding& encoding, const FileNumbers& numbers,
                  std::vector<float>& light);

}  // namespace firstlight::render
