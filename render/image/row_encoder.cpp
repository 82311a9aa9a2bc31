#include "render/image/row_encoder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace firstlight::render {
namespace {

/// As if a little of the pixel were opaque, where nothing is.
constexpr float kLeastAlpha = 1e-6f;

/// Not a number would be handed on from pixel to pixel.
float unless_nan(float number) { return std::isnan(number) ? 0.0f : number; }

}  // namespace

RowEncoder::RowEncoder(const Encoding& encoding, const FileNumbers& numbers, int width, bool fills)
    : encoding_(encoding),
      numbers_(numbers),
      white_(static_cast<float>((1 << numbers.bits) - 1)),
      shift_(fills ? 8 * numbers.channel_bytes() - numbers.bits : 0),
      ditherer_(numbers.dithering, width) {
  const bool is_plain = numbers.bits == 8 && !numbers.grey && !numbers.alpha && numbers.dithering == Dithering::none;
  if (is_plain) table_.emplace(encoding);
  if (numbers.dithering != Dithering::none) {
    decoded_.assign(std::size_t{1} << numbers.bits, std::numeric_limits<float>::quiet_NaN());
  }
}

void RowEncoder::encode(int y, std::span<const Rgb> row, std::span<std::uint8_t> bytes) {
  if (table_) return table_->encode(row, bytes);
  std::uint8_t* to = bytes.data();
  for (std::size_t x = 0; x < row.size(); ++x) encode_pixel(x, static_cast<std::size_t>(y), row[x], to);
}

void RowEncoder::encode(int y, std::span<const PixelColor> row, std::span<std::uint8_t> bytes) {
  std::uint8_t* to = bytes.data();
  for (std::size_t x = 0; x < row.size(); ++x) encode_pixel(x, static_cast<std::size_t>(y), row[x], to);
}

RowEncoder::Channels RowEncoder::channels_of(const PixelColor& pixel) const {
  const float shade = grey(pixel.light);
  Channels channels{pixel.light.x, pixel.light.y, pixel.light.z, 1.0f};
  if (numbers_.grey) channels[0] = shade;
  if (numbers_.alpha) {
    float alpha = 1.0f - pixel.clear;
    if (shade > alpha) alpha = std::min(1.0f, shade);
    if (alpha == 0.0f) alpha = kLeastAlpha;
    for (std::size_t c = 0; c < 3; ++c) channels[c] /= alpha;
    channels[3] = alpha;
  }
  for (float& channel : channels) channel = unless_nan(channel);
  return channels;
}

inline float RowEncoder::decoded(float number) {
  float& known = decoded_[static_cast<std::size_t>(number)];
  if (std::isnan(known)) known = encoding_.decoded(number, white_);
  return known;
}

inline void RowEncoder::put(float number, std::uint8_t*& to) const {
  auto value = static_cast<unsigned>(number);
  if (shift_ > 0) value = value << shift_ | value >> (numbers_.bits - shift_);
  if (numbers_.channel_bytes() == 2) *to++ = static_cast<std::uint8_t>(value >> 8);
  *to++ = static_cast<std::uint8_t>(value & 255);
}

void RowEncoder::encode_pixel(std::size_t x, std::size_t y, const PixelColor& pixel, std::uint8_t*& to) {
  const Channels channels = channels_of(pixel);
  const bool dithers = numbers_.dithering != Dithering::none;
  const ChannelOffsets before = dithers ? ditherer_.before(x) : ChannelOffsets{};
  const float offset = dithers ? ditherer_.before_rounding(x, y) : 0.0f;
  ChannelOffsets error{};
  const auto clipped = [](float number) { return std::clamp(number, 0.0f, 1.0f); };
  for (std::size_t c = 0; c < (numbers_.grey ? 1 : 3); ++c) {
    const float moved = channels[c] + before[c];
    const float number = encoding_.number(moved, white_, offset);
    put(number, to);
    if (dithers) error[c] = clipped(moved) - decoded(number);
  }
  if (numbers_.alpha) {
    const float moved = channels[3] + before[3];
    const float number = quantized(moved, white_, offset);
    put(number, to);
    error[3] = clipped(moved) - number / white_;
  }
  if (dithers) ditherer_.hand_on(x, error);
}

namespace {

void append_pixel(const PixelColor& pixel, const Encoding& encoding, const FileNumbers& numbers,
                  std::vector<float>& light) {
  const Rgb color(encoding.light(pixel.light.x), encoding.light(pixel.light.y), encoding.light(pixel.light.z));
  light.insert(light.end(), {color.x, color.y, color.z});
  if (numbers.alpha) light.push_back(1.0f - pixel.clear);
}

}  // namespace

void append_light(std::span<const Rgb> row, const Encoding& encoding, const FileNumbers& numbers,
                  std::vector<float>& light) {
  for (const Rgb& color : row) append_pixel(color, encoding, numbers, light);
}

void append_light(std::span<const PixelColor> row, const Encoding& encoding, const FileNumbers& numbers,
                  std::vector<float>& light) {
  for (const PixelColor& pixel : row) append_pixel(pixel, encoding, numbers, light);
}

}  // namespace firstlight::render
