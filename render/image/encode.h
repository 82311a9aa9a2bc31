#pragma once

#include "render/image/transfer_curve.h"
#include "render/math/color.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// A number in steps of a file, where `white` stands for 1, moved by `offset` of them and rounded. Not-a-number is 0.
inline float quantized(float value, float white, float offset = 0.0f) {
  const float moved = value + offset / white;
  return moved > 0.0f ? std::floor(std::min(moved, 1.0f) * white + 0.5f) : 0.0f;
}

/// How the colour numbers that a scene is computed in become the numbers in a picture file.
///
/// Units    Working numbers: 0 is black, 1 is white, any range. File numbers: 0 to 255 or 65535, on the sRGB curve
///          unless with_file_gamma() says otherwise.
/// Source   sRGB: IEC 61966-2-1. Rounding and clipping are POV-Ray 3.7's for files without dithering.
class Encoding {
 public:
  /// Working numbers are proportional to light.
  static Encoding linear() { return Encoding(TransferCurve()); }
  /// Working numbers are light ^ (1 / exponent). An exponent within 0.01 of 1 counts as 1.
  static Encoding power(double exponent) { return Encoding(TransferCurve::of_power(exponent)); }
  /// Working numbers are on the sRGB curve.
  static Encoding srgb() { return Encoding({TransferCurve::Kind::srgb}); }
  /// Working numbers are file numbers already, but for the range, whatever the curve of the file.
  static Encoding as_is();

  /// The same working numbers in files whose numbers are light ^ (1 / gamma). Pre: gamma > 0.
  Encoding with_file_gamma(double gamma) const;

  /// The value in a file of 8 bits a channel. Not-a-number is black.
  std::uint8_t byte(float working) const;
  /// The value in a file of 16 bits a channel.
  std::uint16_t word(float working) const;
  /// The value in a file where `white` stands for 1, moved by `offset` steps before it is rounded.
  float number(float working, float white, float offset = 0.0f) const;
  /// The working number that such a value stands for.
  float decoded(float number, float white) const { return to_working_(number / white); }
  /// The value in a file of linear light (OpenEXR, Radiance): unclipped, finite.
  float light(float working) const;

 private:
  explicit Encoding(const TransferCurve& working) : working_(working) { set_file({TransferCurve::Kind::srgb}); }
  void set_file(const TransferCurve& file) {
    to_file_ = Transcoding(working_, file);
    to_working_ = Transcoding(file, working_);
  }

  TransferCurve working_;
  Transcoding to_file_;
  Transcoding to_working_;
  bool is_managed_ = true;
};

/// Encoding::byte() of many colours, one picture's, say: of most numbers it is known from their neighbours.
class ByteTable {
 public:
  explicit ByteTable(const Encoding& encoding);

  /// Red green blue of each colour. Pre: room for 3 * colors.size() of them.
  void encode(std::span<const Rgb> colors, std::span<std::uint8_t> bytes);

 private:
  std::uint8_t byte(float working);
  std::uint16_t ask(float working) const;

  Encoding encoding_;
  std::vector<std::uint16_t> known_;  ///< of each range of numbers: their byte, or kSeveral, or kUnknown
};

/// Red green blue of each colour.
std::vector<std::uint8_t> to_bytes(std::span<const Rgb> colors, const Encoding& encoding);

}  // namespace firstlight::render
