#pragma once

#include <cstdint>

namespace firstlight::render {

/// How numbers stand for light: as they are, by the sRGB curve, or by a power. Computed in single precision, as in POV-Ray.
struct TransferCurve {
  enum class Kind : std::uint8_t { linear, srgb, power };

  Kind kind = Kind::linear;
  float encoding = 1.0f;  ///< of Kind::power: number = light ^ encoding

  /// light = number ^ exponent; one that is 1 within a hundredth is taken for linear. [POV-Ray 3.7]
  static TransferCurve of_power(double exponent);

  bool is_linear() const { return kind == Kind::linear; }
  float to_light(float number) const;
  float from_light(float light) const;
};

/// The way from numbers on one curve to those on another: from a file's to a scene's, or back.
class Transcoding {
 public:
  Transcoding() = default;
  Transcoding(const TransferCurve& from, const TransferCurve& to);

  float operator()(float number) const;

 private:
  TransferCurve from_;
  TransferCurve to_;
};

}  // namespace firstlight::render
