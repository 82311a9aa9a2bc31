#include "render/image/raster.h"

#include <algorithm>
#include <cassert>
#include <type_traits>
#include <utility>

namespace firstlight::render {
namespace {

std::uint8_t to_byte(int sample, int white) {
  return static_cast<std::uint8_t>((std::min(sample, white) * 255 + white / 2) / white);
}

std::uint8_t to_byte(float sample, int /*white*/) {
  if (!(sample > 0.0f)) return 0;  // not-a-number too
  return static_cast<std::uint8_t>(std::min(sample, 1.0f) * 255.0f + 0.5f);
}

}  // namespace

double Raster::value(std::size_t sample) const {
  return std::visit(
      [&](const auto& all) {
        const double number = all[sample];
        return std::is_same_v<decltype(all), const Floats&> ? number : number / white;
      },
      samples);
}

void resolve_palette(Raster& raster) {
  const std::vector<Raster::Color> palette = std::exchange(raster.palette, {});
  const bool opaque = std::all_of(palette.begin(), palette.end(), [](const Raster::Color& c) { return c[3] == 255; });
  const int channels = opaque ? 3 : 4;
  Raster::Bytes colors;
  std::visit(
      [&](const auto& indices) {
        colors.reserve(indices.size() * static_cast<std::size_t>(channels));
        for (const auto index : indices) {
          const Raster::Color& color = palette[static_cast<std::size_t>(index)];
          colors.insert(colors.end(), color.begin(), color.begin() + channels);
        }
      },
      raster.samples);
  raster.channels = channels;
  raster.white = 255;
  raster.samples = std::move(colors);
}

bool join_potential(Raster& raster) {
  const auto* const indices = std::get_if<Raster::Bytes>(&raster.samples);
  if (indices == nullptr || raster.palette.empty() || raster.width % 2 != 0) return false;
  const std::size_t half = static_cast<std::size_t>(raster.width) / 2;
  Raster::Words words;
  words.reserve(indices->size() / 2);
  for (std::size_t row = 0; row < indices->size(); row += 2 * half) {
    for (std::size_t x = row; x < row + half; ++x) {
      words.push_back(static_cast<std::uint16_t>((*indices)[x] << 8 | (*indices)[x + half]));
    }
  }
  raster.width /= 2;
  raster.channels = 1;
  raster.white = 65535;
  raster.samples = std::move(words);
  raster.palette.clear();
  return true;
}

Picture to_picture(Raster raster) {
  assert(raster.palette.empty());
  Picture picture{raster.width, raster.height, {}};
  if (auto* const bytes = std::get_if<Raster::Bytes>(&raster.samples);
      bytes != nullptr && raster.channels == 3 && raster.white == 255) {
    picture.rgb = std::move(*bytes);
    return picture;
  }
  const std::size_t step = static_cast<std::size_t>(raster.channels);
  const std::size_t green = step < 3 ? 0 : 1;
  std::visit(
      [&](const auto& samples) {
        picture.rgb.reserve(samples.size() / step * 3);
        for (std::size_t i = 0; i < samples.size(); i += step) {
          for (const std::size_t channel : {std::size_t{0}, green, 2 * green}) {
            picture.rgb.push_back(to_byte(samples[i + channel], raster.white));
          }
        }
      },
      raster.samples);
  if (step % 2 == 0) {
    std::visit(
        [&](const auto& samples) {
          for (std::size_t i = step - 1; i < samples.size(); i += step) {
            picture.alpha.push_back(to_byte(samples[i], raster.white));
          }
        },
        raster.samples);
  }
  return picture;
}

}  // namespace firstlight::render
