#include "render/image/encode.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace firstlight::render {
namespace {

// ByteTable knows numbers from 2^-12 to 2. Smaller ones are nearly black, and larger ones rare.
constexpr unsigned kRangeBits = 13;
constexpr std::uint32_t kWithinRange = (1u << kRangeBits) - 1;
constexpr std::uint32_t kFirstRange = std::bit_cast<std::uint32_t>(0x1p-12f) >> kRangeBits;
constexpr std::uint32_t kRanges = (std::bit_cast<std::uint32_t>(2.0f) >> kRangeBits) - kFirstRange;
constexpr std::uint16_t kSeveral = 256;
constexpr std::uint16_t kUnknown = 257;

}  // namespace

Encoding Encoding::as_is() {
  Encoding encoding = srgb();
  encoding.is_managed_ = false;
  return encoding;
}

Encoding Encoding::with_file_gamma(double gamma) const {
  Encoding changed = *this;
  if (is_managed_) changed.set_file(TransferCurve::of_power(gamma));
  return changed;
}

float Encoding::number(float working, float white, float offset) const {
  return quantized(to_file_(working), white, offset);
}

std::uint8_t Encoding::byte(float working) const { return static_cast<std::uint8_t>(number(working, 255.0f)); }

std::uint16_t Encoding::word(float working) const { return static_cast<std::uint16_t>(number(working, 65535.0f)); }

float Encoding::light(float working) const {
  const float value = working_.to_light(working);
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

std::vector<std::uint8_t> to_bytes(std::span<const Rgb> colors, const Encoding& encoding) {
  std::vector<std::uint8_t> bytes(colors.size() * 3);
  ByteTable(encoding).encode(colors, bytes);
  return bytes;
}

}  // namespace firstlight::render
