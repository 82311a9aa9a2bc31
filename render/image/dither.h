#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace firstlight::render {

/// Ways to hide the steps between the numbers of a picture file.
enum class Dithering : std::uint8_t { none, bayer2, bayer3, bayer4, diffusion1, diffusion2, floyd_steinberg };

/// By POV-Ray's names: B2, B3, B4, D1, D2, FS.
std::optional<Dithering> find_dithering(std::string_view name);

/// A number for each channel of a pixel, alpha last.
using ChannelOffsets = std::array<float, 4>;

/// Moves the numbers of a picture's pixels, one after the other.
///
/// Order   Rows as they stand in the file, each from the left: errors are handed on to pixels that come later.
/// Source  B. Bayer 1973, "An optimum method for two-level rendition of continuous-tone pictures"; R. Floyd and L.
///         Steinberg
///         1976, "An adaptive algorithm for spatial greyscale"; what each method does here is POV-Ray 3.7's.
class Ditherer {
 public:
  Ditherer(Dithering method, int width);

  /// To be added to a pixel's numbers before they are put on the file's curve.
  ChannelOffsets before(std::size_t x);
  /// To be added, in steps of the file's numbers, before these are rounded.
  float before_rounding(std::size_t x, std::size_t y) const;
  /// By how much the pixel's numbers were larger than those that the file has.
  void hand_on(std::size_t x, const ChannelOffsets& error);

 private:
  void add(std::vector<ChannelOffsets>& row, std::size_t place, const ChannelOffsets& error, float share);

  Dithering method_;
  std::vector<ChannelOffsets> row_;   ///< of errors, at hand_on() of the first pixel changed for the next
  std::vector<ChannelOffsets> next_;  ///< of the row after it
};

}  // namespace firstlight::render
