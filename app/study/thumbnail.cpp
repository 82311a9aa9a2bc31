#include "app/study/thumbnail.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace firstlight::app {
namespace {

float shown(float channel) { return channel > 0.0f ? std::min(channel, 1.0f) : 0.0f; }

/// Where the i-th of `parts` parts of `length` begins.
int part_begin(int i, int parts, int length) { return static_cast<int>(static_cast<std::int64_t>(i) * length / parts); }

}  // namespace

SmallPicture shrink(std::span<const render::Rgb> colors, int width, int height, int most) {
  SmallPicture small;
  const double scale = std::min(1.0, static_cast<double>(most) / std::max({width, height, 1}));
  small.width = std::max(1, static_cast<int>(width * scale + 0.5));
  small.height = std::max(1, static_cast<int>(height * scale + 0.5));
  for (int row = 0; row < small.height; ++row) {
    for (int column = 0; column < small.width; ++column) {
      render::Rgb sum(0.0f);
      int count = 0;
      for (int y = part_begin(row, small.height, height); y < part_begin(row + 1, small.height, height); ++y) {
        for (int x = part_begin(column, small.width, width); x < part_begin(column + 1, small.width, width); ++x) {
          const render::Rgb& color =
              colors[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
          sum += render::Rgb(shown(color.x), shown(color.y), shown(color.z));
          ++count;
        }
      }
      small.colors.push_back(count > 0 ? sum / static_cast<float>(count) : sum);
    }
  }
  return small;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kLetters[group >> (18 - 6 * k) & 63u] : '=';
    }
  }
  return text;
}

}  // namespace firstlight::app
