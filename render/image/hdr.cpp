// Radiance's pictures of light. Source: G. Ward 1991, "Real pixels", Graphics Gems II; the format is described with
// Radiance (filefmts, "Picture Files").

#include "render/image/file_formats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

namespace firstlight::render {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;  ///< three mantissas and an exponent

class Lines {
 public:
  explicit Lines(FileBytes bytes) : left_(bytes) {}

  std::string line() {
    const auto end = std::find(left_.begin(), left_.end(), '\n');
    if (end == left_.end()) throw BrokenPicture(kEndsTooEarly);
    const std::string text(left_.begin(), end);
    left_ = left_.subspan(text.size() + 1);
    return text;
  }
  std::uint8_t byte() {
    if (left_.empty()) throw BrokenPicture(kEndsTooEarly);
    const std::uint8_t value = left_[0];
    left_ = left_.subspan(1);
    return value;
  }
  Rgbe pixel() { return {byte(), byte(), byte(), byte()}; }
  /// The pixel that is next, without taking it.
  Rgbe peek() const {
    if (left_.size() < 4) throw BrokenPicture(kEndsTooEarly);
    return {left_[0], left_[1], left_[2], left_[3]};
  }

 private:
  FileBytes left_;
};

/// Bytes of one kind after the other, in runs and as they are.
void read_packed_row(Lines& file, std::vector<Rgbe>& row) {
  file.pixel();
  for (std::size_t channel = 0; channel < 4; ++channel) {
    for (std::size_t x = 0; x < row.size();) {
      std::size_t count = file.byte();
      const bool is_run = count > 128;
      if (is_run) count -= 128;
      if (count == 0 || count > row.size() - x) throw BrokenPicture("a run of equal pixels is longer than its row");
      std::uint8_t value = is_run ? file.byte() : std::uint8_t{0};
      for (; count > 0; --count) {
        if (!is_run) value = file.byte();
        row[x++][channel] = value;
      }
    }
  }
}

/// Whole pixels; (1, 1, 1, n) repeats the last one n times, and another one behind it 256 n times.
void read_plain_row(Lines& file, std::vector<Rgbe>& row) {
  int shift = 0;
  for (std::size_t x = 0; x < row.size();) {
    const Rgbe pixel = file.pixel();
    if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
      row[x++] = pixel;
      shift = 0;
      continue;
    }
    const std::size_t count = std::size_t{pixel[3]} << shift;
    if (x == 0 || count > row.size() - x) throw BrokenPicture("a run of equal pixels is longer than its row");
    std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
    x += count;
    shift += 8;
    if (shift > 16) throw BrokenPicture("a run of equal pixels is longer than its row");
  }
}

/// The middle of what the mantissa was cut from.
float light_of(std::uint8_t mantissa, double step) { return static_cast<float>((mantissa + 0.5) * step); }

}  // namespace

bool is_hdr(FileBytes file) {
  return file.size() >= 10 &&
         (std::memcmp(file.data(), "#?RADIANCE", 10) == 0 || std::memcmp(file.data(), "#?RGBE", 6) == 0);
}

Raster read_hdr(FileBytes file) {
  Lines lines(file);
  while (!lines.line().empty()) {
  }
  const std::string size = lines.line();
  char up = 0, across = 0;
  int height = 0, width = 0;
  if (std::sscanf(size.c_str(), "%cY %d %cX %d", &up, &height, &across, &width) != 4 || up != '-' || across != '+') {
    throw BrokenPicture("its rows do not go from the top and from the left");
  }
  check_size(width, height, file.size(), 8192);  // 8 bytes for 65535 pixels
  Raster raster;
  raster.width = width;
  raster.height = height;
  raster.white = 1;
  raster.gamma = {FileGamma::Curve::power, 1.0};
  auto& samples = raster.samples.emplace<Raster::Floats>();
  std::vector<Rgbe> row(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    const Rgbe first = lines.peek();
    const bool is_packed = width >= 8 && first[0] == 2 && first[1] == 2 && (first[2] << 8 | first[3]) == width;
    if (is_packed) {
      read_packed_row(lines, row);
    } else {
      read_plain_row(lines, row);
    }
    for (const Rgbe& pixel : row) {
      const double step = std::ldexp(1.0, pixel[3] - (128 + 8));
      for (std::size_t channel = 0; channel < 3; ++channel) samples.push_back(light_of(pixel[channel], step));
    }
  }
  return raster;
}

}  // namespace firstlight::render
