// GIF: the first picture of a file. Source: "Graphics Interchange Format, Version 89a", CompuServe 1990.

#include "render/image/file_formats.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace firstlight::render {
namespace {

/// The file from its front.
class Bytes {
 public:
  explicit Bytes(FileBytes bytes) : left_(bytes) {}

  FileBytes take(std::size_t count) {
    if (left_.size() < count) throw BrokenPicture(kEndsTooEarly);
    const FileBytes taken = left_.first(count);
    left_ = left_.subspan(count);
    return taken;
  }
  int byte() { return take(1)[0]; }
  int word() {
    const FileBytes two = take(2);
    return two[0] | two[1] << 8;
  }
  /// A block of up to 255 bytes; an empty one ends a row of them.
  FileBytes block() { return take(static_cast<std::size_t>(byte())); }

 private:
  FileBytes left_;
};

std::vector<Raster::Color> read_palette(Bytes& bytes, int flags) {
  std::vector<Raster::Color> palette;
  for (int i = 0; i < 2 << (flags & 7); ++i) {
    const FileBytes rgb = bytes.take(3);
    palette.push_back({rgb[0], rgb[1], rgb[2], 255});
  }
  return palette;
}

/// Numbers of growing size, low bits first, from the blocks of a picture.
class Codes {
 public:
  explicit Codes(Bytes& bytes) : bytes_(bytes) {}

  int take(int size) {
    while (count_ < size) {
      if (block_.empty()) block_ = bytes_.block();
      if (block_.empty()) throw BrokenPicture(kEndsTooEarly);
      bits_ |= static_cast<std::uint32_t>(block_[0]) << count_;
      block_ = block_.subspan(1);
      count_ += 8;
    }
    const auto code = static_cast<int>(bits_ & ((1u << size) - 1));
    bits_ >>= size;
    count_ -= size;
    return code;
  }

 private:
  Bytes& bytes_;
  FileBytes block_;
  std::uint32_t bits_ = 0;
  int count_ = 0;
};

/// Lempel, Ziv and Welch's compression: a code is a byte, or the text of another code and a byte more.
void unpack(Bytes& bytes, Raster::Bytes& pixels) {
  constexpr int kMostCodes = 4096;
  const int literal_bits = bytes.byte();
  if (literal_bits < 1 || literal_bits > 8) throw BrokenPicture("its pixels have no size that there is");
  const int clear = 1 << literal_bits;
  const int end = clear + 1;
  std::array<std::uint16_t, kMostCodes> before;
  std::array<std::uint8_t, kMostCodes> last;
  std::array<std::uint8_t, kMostCodes> text;
  Codes codes(bytes);
  int size = literal_bits + 1;
  int next = end + 1;
  int former = -1;
  std::uint8_t first = 0;
  for (std::size_t done = 0; done < pixels.size();) {
    const int code = codes.take(size);
    if (code == end) throw BrokenPicture(kEndsTooEarly);
    if (code == clear) {
      size = literal_bits + 1;
      next = end + 1;
      former = -1;
      continue;
    }
    if (code > next || (code == next && former < 0) || (former < 0 && code >= clear)) {
      throw BrokenPicture("its pixels are not compressed as they should be");
    }
    int rest = code;
    std::size_t length = 0;
    if (code == next) {
      text[length++] = first;
      rest = former;
    }
    for (; rest > end; rest = before[static_cast<std::size_t>(rest)])
      text[length++] = last[static_cast<std::size_t>(rest)];
    first = static_cast<std::uint8_t>(rest);
    text[length++] = first;
    if (former >= 0 && next < kMostCodes) {
      before[static_cast<std::size_t>(next)] = static_cast<std::uint16_t>(former);
      last[static_cast<std::size_t>(next)] = first;
      ++next;
      if (next == 1 << size && size < 12) ++size;
    }
    former = code;
    for (; length > 0 && done < pixels.size(); --length) pixels[done++] = text[length - 1];
  }
}

/// Rows that come in four passes, to their places.
void straighten(Raster& raster) {
  const auto width = static_cast<std::size_t>(raster.width);
  const Raster::Bytes woven = std::get<Raster::Bytes>(raster.samples);
  Raster::Bytes& rows = std::get<Raster::Bytes>(raster.samples);
  std::size_t from = 0;
  for (const auto& [start, step] : {std::pair(0, 8), std::pair(4, 8), std::pair(2, 4), std::pair(1, 2)}) {
    for (int y = start; y < raster.height; y += step, from += width) {
      std::copy_n(woven.begin() + static_cast<std::ptrdiff_t>(from), width,
                  rows.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * width));
    }
  }
}

}  // namespace

bool is_gif(FileBytes file) {
  return file.size() >= 13 &&
         (std::memcmp(file.data(), "GIF87a", 6) == 0 || std::memcmp(file.data(), "GIF89a", 6) == 0);
}

Raster read_gif(FileBytes file) {
  constexpr int kHasPalette = 0x80;
  constexpr int kInterlaced = 0x40;
  constexpr int kExtension = 0x21;
  constexpr int kControl = 0xf9;
  constexpr int kPicture = 0x2c;
  Bytes bytes(file);
  bytes.take(10);
  const int screen_flags = bytes.byte();
  bytes.take(2);
  Raster raster;
  if ((screen_flags & kHasPalette) != 0) raster.palette = read_palette(bytes, screen_flags);
  int clear_index = -1;
  int mark = bytes.byte();
  for (; mark == kExtension; mark = bytes.byte()) {
    const bool controls = bytes.byte() == kControl;
    for (FileBytes block = bytes.block(); !block.empty(); block = bytes.block()) {
      if (controls && block.size() >= 4 && (block[0] & 1) != 0) clear_index = block[3];
    }
  }
  if (mark != kPicture) throw BrokenPicture("there is no picture in it");
  bytes.take(4);
  raster.width = bytes.word();
  raster.height = bytes.word();
  const int flags = bytes.byte();
  if ((flags & kHasPalette) != 0) raster.palette = read_palette(bytes, flags);
  if (raster.palette.empty()) throw BrokenPicture("it has no palette");
  // A code of 12 bits stands for at most 4096 pixels.
  check_size(raster.width, raster.height, file.size(), 4096);
  raster.channels = 1;
  auto& pixels = raster.samples.emplace<Raster::Bytes>(static_cast<std::size_t>(raster.width) *
                                                       static_cast<std::size_t>(raster.height));
  unpack(bytes, pixels);
  if (*std::max_element(pixels.begin(), pixels.end()) >= raster.palette.size()) {
    throw BrokenPicture("a pixel's index is beyond the palette");
  }
  if (clear_index >= 0 && static_cast<std::size_t>(clear_index) < raster.palette.size()) {
    raster.palette[static_cast<std::size_t>(clear_index)][3] = 0;
  }
  if ((flags & kInterlaced) != 0) straighten(raster);
  return raster;
}

}  // namespace firstlight::render
