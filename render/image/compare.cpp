#include "render/image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace firstlight::render {
namespace {

int alpha_of(const Picture& picture, std::size_t pixel) { return picture.alpha.empty() ? 255 : picture.alpha[pixel]; }

}  // namespace

std::optional<Difference> compare(const Picture& a, const Picture& b, int tolerance) {
  if (a.width != b.width || a.height != b.height || a.rgb.size() != b.rgb.size()) return std::nullopt;
  Difference result;
  std::size_t within = 0;
  std::uint64_t squares = 0;
  const std::size_t pixels = a.rgb.size() / 3;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    int largest = 0;
    for (std::size_t channel = 3 * pixel; channel < 3 * pixel + 3; ++channel) {
      const int difference = std::abs(int{a.rgb[channel]} - int{b.rgb[channel]});
      largest = std::max(largest, difference);
      squares += static_cast<std::uint64_t>(difference * difference);
    }
    largest = std::max(largest, std::abs(alpha_of(a, pixel) - alpha_of(b, pixel)));
    if (largest <= tolerance) ++within;
    if (largest > result.worst) {
      result.worst = largest;
      result.worst_x = static_cast<int>(pixel % static_cast<std::size_t>(a.width));
      result.worst_y = static_cast<int>(pixel / static_cast<std::size_t>(a.width));
    }
  }
  if (pixels > 0) result.share_within = static_cast<double>(within) / static_cast<double>(pixels);
  // Peak signal to noise ratio: 10 log10(255^2 / mean square error). No error divides by zero: infinite, as it should
  // be.
  result.psnr = 10.0 * std::log10(255.0 * 255.0 * static_cast<double>(a.rgb.size()) / static_cast<double>(squares));
  if (squares == 0) result.psnr = HUGE_VAL;
  return result;
}

std::string summary(const Difference& difference, int tolerance) {
  return fmt::format("{:.2f} % of pixels within {}/255, worst {} at ({}, {}), {:.1f} dB",
                     100.0 * difference.share_within, tolerance, difference.worst, difference.worst_x,
                     difference.worst_y, difference.psnr);
}

}  // namespace firstlight::render
