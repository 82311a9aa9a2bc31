#include "render/image/file_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

namespace firstlight::render {
namespace {

bool is_space(std::uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_digit(std::uint8_t c) { return c >= '0' && c <= '9'; }

/// Numbers written out, with white space and comments (from # to the end of the line) between them.
class NumberText {
 public:
  explicit NumberText(FileBytes text) : left_(text) {}

  /// The next one. Pre: most <= 65535, but for the sizes of the picture.
  int number(int most) {
    skip_space();
    std::int64_t value = 0;
    std::size_t digits = 0;
    for (; digits < left_.size() && is_digit(left_[digits]); ++digits) {
      value = std::min<std::int64_t>(value * 10 + (left_[digits] - '0'), std::int64_t{most} + 1);
    }
    if (digits == 0) throw BrokenPicture(left_.empty() ? kEndsTooEarly : "there is no number where one is due");
    if (value > most) throw BrokenPicture(fmt::format("it has a number above {}", most));
    left_ = left_.subspan(digits);
    return static_cast<int>(value);
  }
  /// The next digit of a bitmap; they need no space between them.
  int bit() {
    skip_space();
    if (left_.empty()) throw BrokenPicture(kEndsTooEarly);
    if (left_[0] != '0' && left_[0] != '1') throw BrokenPicture("there is no 0 or 1 where one is due");
    const int value = left_[0] - '0';
    left_ = left_.subspan(1);
    return value;
  }
  /// Returns the bytes behind the one white space that ends a header.
  FileBytes rest() const {
    if (left_.empty()) throw BrokenPicture(kEndsTooEarly);
    return left_.subspan(1);
  }
  std::size_t size() const { return left_.size(); }

 private:
  void skip_space() {
    while (!left_.empty() && (is_space(left_[0]) || left_[0] == '#')) {
      const auto end = left_[0] == '#' ? std::find(left_.begin(), left_.end(), '\n') : left_.begin() + 1;
      left_ = left_.subspan(static_cast<std::size_t>(end - left_.begin()));
    }
  }

  FileBytes left_;
};

/// `next` gives one sample after the other.
template <class Sample, class Next>
std::vector<Sample> gather(std::size_t count, Next next) {
  std::vector<Sample> samples;
  samples.reserve(count);
  std::generate_n(std::back_inserter(samples), count, [&] { return static_cast<Sample>(next()); });
  return samples;
}

/// Rows of bits, each filled up to whole bytes; 1 is black.
Raster::Bytes unpack_bits(FileBytes bytes, std::size_t width, std::size_t height) {
  const std::size_t row = (width + 7) / 8;
  if (bytes.size() < row * height) throw BrokenPicture(kEndsTooEarly);
  Raster::Bytes samples;
  samples.reserve(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const int bit = bytes[y * row + x / 8] >> (7 - x % 8) & 1;
      samples.push_back(static_cast<std::uint8_t>(1 - bit));
    }
  }
  return samples;
}

}  // namespace

bool is_pnm(FileBytes file) {
  return file.size() >= 3 && file[0] == 'P' && file[1] >= '1' && file[1] <= '6' &&
         (is_space(file[2]) || file[2] == '#');
}

Raster read_pnm(FileBytes file) {
  const char kind = static_cast<char>(file[1]);
  const bool bitmap = kind == '1' || kind == '4';
  const bool text = kind <= '3';
  NumberText header(file.subspan(2));
  Raster raster;
  raster.width = header.number(static_cast<int>(kMostPixels));
  raster.height = header.number(static_cast<int>(kMostPixels));
  raster.channels = kind == '3' || kind == '6' ? 3 : 1;
  raster.white = bitmap ? 1 : header.number(65535);
  if (raster.white == 0) throw BrokenPicture("its greatest number is 0");
  check_size(raster.width, raster.height, header.size(), kind == '4' ? 8 : 1);

  const std::size_t width = static_cast<std::size_t>(raster.width);
  const std::size_t height = static_cast<std::size_t>(raster.height);
  const std::size_t count = width * height * static_cast<std::size_t>(raster.channels);
  const bool wide = raster.white > 255;
  const auto within = [&](int sample) { return std::min(sample, raster.white); };
  if (kind == '4') {
    raster.samples = unpack_bits(header.rest(), width, height);
  } else if (bitmap) {
    raster.samples = gather<std::uint8_t>(count, [&] { return 1 - header.bit(); });
  } else if (text) {
    const auto next = [&] { return header.number(raster.white); };
    if (wide) {
      raster.samples = gather<std::uint16_t>(count, next);
    } else {
      raster.samples = gather<std::uint8_t>(count, next);
    }
  } else {
    const FileBytes bytes = header.rest();
    if (bytes.size() < count * (wide ? 2 : 1)) throw BrokenPicture(kEndsTooEarly);
    auto at = bytes.begin();
    if (wide) {
      raster.samples = gather<std::uint16_t>(count, [&] {
        const int high = *at++;
        return within(high << 8 | *at++);
      });
    } else {
      raster.samples = gather<std::uint8_t>(count, [&] { return within(*at++); });
    }
  }
  return raster;
}

void make_ppm(const PictureRows& picture, const PutBytes& put) {
  const std::string header = fmt::format("P{}\n{} {}\n{}\n", picture.channels == 1 ? 5 : 6, picture.width,
                                         picture.height, (1 << picture.bits) - 1);
  put(std::vector<std::uint8_t>(header.begin(), header.end()));
  std::vector<std::uint8_t> row(picture.row_bytes());
  for (int y = 0; y < picture.height; ++y) {
    picture.make(y, row);
    put(row);
  }
}

}  // namespace firstlight::render
