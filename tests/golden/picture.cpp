#include "tests/golden/picture.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace firstlight::golden {

std::array<int, 3> Picture::at(int x, int y) const {
  const std::size_t i =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  return {rgb[i], rgb[i + 1], rgb[i + 2]};
}

std::optional<Picture> read_picture(const std::filesystem::path& file, std::string& why) {
  const auto input = OIIO::ImageInput::open(file.string());
  if (!input) {
    why = OIIO::geterror();
    return std::nullopt;
  }
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.nchannels < 3) {
    why = fmt::format("{} has {} channels, not red, green and blue", file.string(), spec.nchannels);
    return std::nullopt;
  }
  Picture picture{spec.width, spec.height, {}};
  picture.rgb.resize(3 * static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height));
  if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, picture.rgb.data())) {
    why = input->geterror();
    return std::nullopt;
  }
  return picture;
}

bool write_picture(const Picture& picture, const std::filesystem::path& file) {
  const auto output = OIIO::ImageOutput::create(file.string());
  const OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
  return output && output->open(file.string(), spec) &&
         output->write_image(OIIO::TypeDesc::UINT8, picture.rgb.data()) && output->close();
}

Comparison compare(const Picture& first, const Picture& second, int tolerance) {
  Comparison result;
  double squares = 0;
  long agreeing = 0;
  for (int y = 0; y < first.height; ++y) {
    for (int x = 0; x < first.width; ++x) {
      const auto a = first.at(x, y);
      const auto b = second.at(x, y);
      int largest = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const int difference = std::abs(a[c] - b[c]);
        squares += difference * difference;
        largest = std::max(largest, difference);
      }
      if (largest <= tolerance) ++agreeing;
      if (largest > result.worst) {
        result.worst = largest;
        result.x = x;
        result.y = y;
        result.first = a;
        result.second = b;
      }
    }
  }
  const double pixels = static_cast<double>(first.width) * first.height;
  result.share = static_cast<double>(agreeing) / pixels;
  // PSNR = 10 log10(255^2 / mean squared difference)
  result.psnr =
      squares > 0 ? 10 * std::log10(255.0 * 255.0 * 3 * pixels / squares) : std::numeric_limits<double>::infinity();
  return result;
}

std::string Comparison::summary() const {
  return fmt::format(
      "{:.2f} % of the pixels agree, PSNR {:.1f} dB, worst pixel ({}, {}): ({}) against ({}), {} of 255 apart",
      100 * share, psnr, x, y, fmt::join(first, ", "), fmt::join(second, ", "), worst);
}

Picture difference_picture(const Picture& first, const Picture& second) {
  constexpr int kStrength = 16;
  Picture result{first.width, first.height, {}};
  result.rgb.resize(first.rgb.size());
  for (std::size_t i = 0; i < first.rgb.size(); ++i) {
    const int difference = std::abs(int{first.rgb[i]} - int{second.rgb[i]});
    result.rgb[i] = static_cast<std::uint8_t>(std::min(255, kStrength * difference));
  }
  return result;
}

}  // namespace firstlight::golden
