#pragma once

#include "render/image/picture.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace firstlight::render {

/// Pictures with more pixels than this are taken for damaged files.
constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;

/// How a file says its numbers stand for light. Where it says nothing, what its format is used for decides.
struct FileGamma {
  enum class Curve { unstated, srgb, power };
  Curve curve = Curve::unstated;
  double exponent = 1.0;  ///< of `power`: light = value ^ exponent

  bool operator==(const FileGamma&) const = default;
};

/// A picture as its file holds it, of the file's own depth and channels, colours not multiplied by alpha.
///
/// Units    An integer sample stands for sample / white, a float for itself.
/// Order    The samples of a pixel are neighbours; rows from the top.
struct Raster {
  using Bytes = std::vector<std::uint8_t>;
  using Words = std::vector<std::uint16_t>;
  using Floats = std::vector<float>;
  using Color = std::array<std::uint8_t, 4>;  ///< red green blue alpha, of 255

  int width = 0;
  int height = 0;
  int channels = 3;  ///< 1: grey, or indices; 2: grey alpha; 3: red green blue; 4: red green blue alpha
  int white = 255;   ///< up to 255 the samples are Bytes, up to 65535 Words
  std::variant<Bytes, Words, Floats> samples;
  std::vector<Color> palette;  ///< when it is not empty, the samples are indices into it, all of them valid
  FileGamma gamma;

  /// The sample of that number, 0 for black and 1 for white.
  double value(std::size_t sample) const;
};

/// The samples of a file with a palette become the colours they stand for, or stay indices.
enum class Palette { resolve, keep };

/// Puts the colours into the samples' place: red green blue, with alpha if a colour is not opaque.
void resolve_palette(Raster& raster);

/// Makes a grey picture of 16 bits and half the width of one of a continuous potential, whose right half holds the
/// lower bytes of the left half's indices. False where it is none: without a palette or of odd width. [Fractint]
bool join_potential(Raster& raster);

/// 8 bits a channel; grey becomes colour, what is outside 0 to 1 is clipped. Pre: no palette.
Picture to_picture(Raster raster);

}  // namespace firstlight::render
