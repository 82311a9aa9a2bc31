#include "render/image/encode.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace firstlight::render {
namespace {

// The sRGB curve in single precision, as POV-Ray computes it.
float to_srgb(float light) {
  return light <= 0.0031308f ? light * 12.92f : 1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f;
}

// ByteTable knows numbers from 2^-12 to 2. Smaller ones are nearly black, and larger ones rare.
constexpr unsigned kRangeBits = 13;
constexpr std::uint32_t kWithinRange = (1u << kRangeBits) - 1;
constexpr std::uint32_t kFirstRange = std::bit_cast<std::uint32_t>(0x1p-12f) >> kRangeBits;
constexpr std::uint32_t kRanges = (std::bit_cast<std::uint32_t>(2.0f) >> kRangeBits) - kFirstRange;
constexpr std::uint16_t kSeveral = 256;
constexpr std::uint16_t kUnknown = 257;

float from_srgb(float value) { return value < 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f); }

// POV-Ray's tolerance of powers, on what it raises light to.
bool is_one(double exponent) { return std::abs(1.0 - exponent) <= 0.01; }

float raised(float value, float exponent) { return std::pow(std::max(value, 0.0f), exponent); }

}  // namespace

Encoding::Encoding(Working working, double exponent) : working_(working), working_exponent_(exponent) {
  if (working != Working::power) return;
  encoding_ = Curve::srgb;
  if (exponent == 1.0) return;
  decoding_ = Curve::power;
  decoding_exponent_ = static_cast<float>(exponent);
}

Encoding Encoding::power(double exponent) { return {Working::power, is_one(1.0 / exponent) ? 1.0 : exponent}; }

Encoding Encoding::with_file_gamma(double gamma) const {
  Encoding changed = *this;
  if (working_ == Working::unmanaged) return changed;
  // One power instead of two.
  const double exponent = working_ == Working::power ? working_exponent_ / gamma : 1.0 / gamma;
  changed.decoding_ = working_ == Working::srgb ? Curve::srgb : Curve::none;
  changed.encoding_ = is_one(exponent) ? Curve::none : Curve::power;
  changed.encoding_exponent_ = static_cast<float>(exponent);
  return changed;
}

float Encoding::file_number(float working) const {
  float value = working;
  if (decoding_ == Curve::power) value = raised(value, decoding_exponent_);
  if (decoding_ == Curve::srgb) value = from_srgb(value);
  if (encoding_ == Curve::power) value = raised(value, encoding_exponent_);
  if (encoding_ == Curve::srgb) value = to_srgb(value);
  return value;
}

std::uint8_t Encoding::byte(float working) const {
  const float value = file_number(working);
  if (!(value > 0.0f)) return 0;
  return static_cast<std::uint8_t>(std::floor(std::min(value, 1.0f) * 255.0f + 0.5f));
}

std::uint16_t Encoding::word(float working) const {
  const float value = file_number(working);
  if (!(value > 0.0f)) return 0;
  return static_cast<std::uint16_t>(std::floor(std::min(value, 1.0f) * 65535.0f + 0.5f));
}

float Encoding::light(float working) const {
  float value = working;
  if (working_ != Working::power) value = from_srgb(working);
  if (working_exponent_ != 1.0) value = raised(working, static_cast<float>(working_exponent_));
  if (std::isnan(value)) return 0.0f;
  constexpr float kLargest = std::numeric_limits<float>::max();
  return std::clamp(value, -kLargest, kLargest);
}

// Ranges share their upper bits: sign, exponent, and ten of the mantissa. byte() grows with its number, so that what
// becomes of a range's ends becomes of all between them.
ByteTable::ByteTable(const Encoding& encoding) : encoding_(encoding), known_(kRanges, kUnknown) {}

std::uint16_t ByteTable::ask(float working) const {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(working);
  const std::uint8_t low = encoding_.byte(std::bit_cast<float>(bits & ~kWithinRange));
  const std::uint8_t high = encoding_.byte(std::bit_cast<float>(bits | kWithinRange));
  return low == high ? low : kSeveral;
}

inline std::uint8_t ByteTable::byte(float working) {
  const std::uint32_t range = (std::bit_cast<std::uint32_t>(working) >> kRangeBits) - kFirstRange;
  if (range >= kRanges) return encoding_.byte(working);
  std::uint16_t& known = known_[range];
  if (known == kUnknown) known = ask(working);
  return known == kSeveral ? encoding_.byte(working) : static_cast<std::uint8_t>(known);
}

void ByteTable::encode(std::span<const Rgb> colors, std::span<std::uint8_t> bytes) {
  std::size_t i = 0;
  for (const Rgb& color : colors) {
    for (const float channel : {color.x, color.y, color.z}) bytes[i++] = byte(channel);
  }
}

void encode_words(std::span<const Rgb> colors, const Encoding& encoding, std::span<std::uint8_t> bytes) {
  std::size_t i = 0;
  for (const Rgb& color : colors) {
    for (const float channel : {color.x, color.y, color.z}) {
      const std::uint16_t word = encoding.word(channel);
      bytes[i++] = static_cast<std::uint8_t>(word >> 8);
      bytes[i++] = static_cast<std::uint8_t>(word & 255);
    }
  }
}

std::vector<std::uint8_t> to_bytes(std::span<const Rgb> colors, const Encoding& encoding) {
  std::vector<std::uint8_t> bytes(colors.size() * 3);
  ByteTable(encoding).encode(colors, bytes);
  return bytes;
}

std::vector<float> to_light(std::span<const Rgb> colors, const Encoding& encoding) {
  std::vector<float> values;
  values.reserve(colors.size() * 3);
  for (const Rgb& color : colors) {
    for (const float channel : {color.x, color.y, color.z}) values.push_back(encoding.light(channel));
  }
  return values;
}

}  // namespace firstlight::render
