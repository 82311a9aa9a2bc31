#include "app/compare/difference.h"

#include "render/image/compare.h"
#include "render/image/flip.h"
#include "render/math/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

namespace firstlight::app::compare {
namespace {

std::vector<int> color_at(const render::Picture& picture, int x, int y, bool with_alpha) {
  const auto pixel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
  std::vector<int> color{picture.rgb[3 * pixel], picture.rgb[3 * pixel + 1], picture.rgb[3 * pixel + 2]};
  if (with_alpha) color.push_back(picture.alpha.empty() ? 255 : picture.alpha[pixel]);
  return color;
}

/// 10 log10(255^2 / mean square)
double psnr_of(double mean_square) {
  return mean_square > 0.0 ? 10.0 * std::log10(255.0 * 255.0 / mean_square) : std::numeric_limits<double>::infinity();
}

double mean_of_differences(const render::Picture& a, const render::Picture& b) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    sum += static_cast<std::uint64_t>(std::abs(int{a.rgb[i]} - int{b.rgb[i]}));
  }
  return static_cast<double>(sum) / static_cast<double>(a.rgb.size());
}

/// The mean square of the differences of the means of blocks; a smaller block at the border counts for the pixels it
/// has.
double mean_square_of_blocks(const render::Picture& a, const render::Picture& b) {
  constexpr int kBlock = 8;
  const auto blocks = static_cast<std::size_t>((a.width + kBlock - 1) / kBlock);
  double sum = 0.0;
  std::vector<int> row(3 * blocks);  // of the pixels of each block, the sum of the differences of a channel
  for (int top = 0; top < a.height; top += kBlock) {
    const int height = std::min(kBlock, a.height - top);
    std::ranges::fill(row, 0);
    for (int y = top; y < top + height; ++y) {
      const std::size_t begin = 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width);
      for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(a.width); ++i) {
        row[i / (3 * kBlock) * 3 + i % 3] += int{a.rgb[begin + i]} - int{b.rgb[begin + i]};
      }
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      const int width = std::min(kBlock, a.width - kBlock * static_cast<int>(i / 3));
      // pixels * (sum / pixels)^2
      sum += static_cast<double>(row[i]) * row[i] / (width * height);
    }
  }
  return sum / static_cast<double>(a.rgb.size());
}

/// Proportional to light. Source: sRGB, IEC 61966-2-1.
std::vector<render::Rgb> light_of(const render::Picture& picture) {
  std::array<float, 256> light;
  for (std::size_t i = 0; i < light.size(); ++i) {
    const double value = static_cast<double>(i) / 255.0;
    light[i] = static_cast<float>(value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
  }
  std::vector<render::Rgb> colors;
  colors.reserve(picture.rgb.size() / 3);
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    colors.emplace_back(light[picture.rgb[i]], light[picture.rgb[i + 1]], light[picture.rgb[i + 2]]);
  }
  return colors;
}

}  // namespace

PictureDifference difference(const render::Picture& first, const render::Picture& second, int tolerance) {
  PictureDifference result;
  const render::Difference found = *render::compare(first, second, tolerance);
  result.width = first.width;
  result.height = first.height;
  result.share = found.share_within;
  result.worst = found.worst;
  result.x = found.worst_x;
  result.y = found.worst_y;
  result.psnr = found.psnr;
  result.rms = 255.0 * std::pow(10.0, -found.psnr / 20.0);  // the inverse of psnr_of()
  result.mean = mean_of_differences(first, second);
  result.psnr_8x8 = psnr_of(mean_square_of_blocks(first, second));
  result.flip = render::Flip(light_of(first), first.width, first.height).mean(light_of(second));
  const bool with_alpha = !first.alpha.empty() || !second.alpha.empty();
  result.first = color_at(first, result.x, result.y, with_alpha);
  result.second = color_at(second, result.x, result.y, with_alpha);
  return result;
}

render::Picture difference_map(const render::Picture& first, const render::Picture& second) {
  constexpr int kStrength = 16;
  render::Picture map = first;
  for (std::size_t i = 0; i < map.rgb.size(); ++i) {
    const int apart = std::abs(int{first.rgb[i]} - int{second.rgb[i]});
    map.rgb[i] = static_cast<std::uint8_t>(std::min(255, kStrength * apart));
  }
  return map;
}

render::Picture flip_map(const render::Picture& first, const render::Picture& second) {
  // "Magma" of matplotlib (CC0), at five places: its lightness grows evenly.
  constexpr std::array<std::array<double, 3>, 5> kColors{
      {{0, 0, 4}, {81, 18, 124}, {183, 55, 121}, {252, 137, 97}, {252, 253, 191}}};
  render::Picture map = first;
  const std::vector<float> errors = render::Flip(light_of(first), first.width, first.height).map(light_of(second));
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double place = std::clamp(double{errors[i]}, 0.0, 1.0) * (kColors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kColors.size() - 2);
    const double part = place - static_cast<double>(below);
    for (std::size_t c = 0; c < 3; ++c) {
      map.rgb[3 * i + c] =
          static_cast<std::uint8_t>(kColors[below][c] + part * (kColors[below + 1][c] - kColors[below][c]) + 0.5);
    }
  }
  return map;
}

Status judge(const PictureDifference& difference, const Thresholds& thresholds) {
  const bool by_share = thresholds.share || !thresholds.psnr;
  const bool share = !by_share || 100.0 * difference.share >= thresholds.share.value_or(kShare);
  const bool psnr = !thresholds.psnr || difference.psnr >= *thresholds.psnr;
  if (share && psnr) return Status::agrees;
  return difference.psnr_8x8 >= thresholds.psnr_8x8 ? Status::warns : Status::differs;
}

}  // namespace firstlight::app::compare
