// Truevision TGA. Source: "Truevision TGA File Format Specification, Version 2.0", 1991.

#include "render/image/file_formats.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

constexpr std::size_t kHeaderSize = 18;
constexpr std::uint8_t kRuns = 8;                                  // of the kind
constexpr std::uint8_t kFromTop = 0x20;                            // of the last byte of the header
constexpr std::string_view kSignature("TRUEVISION-XFILE.\0", 18);  // ends files of version 2

enum class Kind { palette = 1, color = 2, grey = 3 };

/// Numbers are little endian.
int word(const std::uint8_t* bytes) { return bytes[0] | bytes[1] << 8; }

struct Header {
  std::size_t id_length;
  bool has_palette;
  Kind kind;
  bool runs;  ///< run-length encoded
  int palette_first, palette_length, palette_bits;
  int width, height;
  int bits;  ///< of a pixel
  bool from_right, from_top;
  bool interleaved;
};

Header header_of(FileBytes file) {
  const std::uint8_t* const at = file.data();
  return {.id_length = at[0],
          .has_palette = at[1] == 1,
          .kind = static_cast<Kind>(at[2] & 7),
          .runs = (at[2] & kRuns) != 0,
          .palette_first = word(at + 3),
          .palette_length = word(at + 5),
          .palette_bits = at[7],
          .width = word(at + 12),
          .height = word(at + 14),
          .bits = at[16],
          .from_right = (at[17] & 0x10) != 0,
          .from_top = (at[17] & kFromTop) != 0,
          .interleaved = (at[17] & 0xc0) != 0};
}

bool is_color(int bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }

bool is_known(const Header& header) {
  switch (header.kind) {
    case Kind::palette:
      return header.has_palette && (header.bits == 8 || header.bits == 16) && is_color(header.palette_bits) &&
             header.palette_length > 0;
    case Kind::color:
      return is_color(header.bits);
    case Kind::grey:
      return header.bits == 8 || header.bits == 16;
  }
  return false;
}

std::size_t bytes_of(int bits) { return static_cast<std::size_t>((bits + 7) / 8); }

/// The pixels of the file in its own order: copied, or run by run.
std::vector<std::uint8_t> unpack(FileBytes data, bool runs, std::size_t pixel, std::size_t size) {
  std::vector<std::uint8_t> out;
  const auto take = [&](std::size_t count) {
    if (count > data.size()) throw BrokenPicture(kEndsTooEarly);
    const FileBytes taken = data.first(count);
    data = data.subspan(count);
    return taken;
  };
  if (!runs) {
    const FileBytes all = take(size);
    return {all.begin(), all.end()};
  }
  out.reserve(size + 128 * pixel);
  while (out.size() < size) {
    const std::uint8_t packet = take(1)[0];
    const std::size_t count = (packet & 0x7fu) + 1u;
    if ((packet & 0x80) == 0) {
      const FileBytes several = take(std::min(count * pixel, size - out.size()));
      out.insert(out.end(), several.begin(), several.end());
    } else {
      const FileBytes one = take(pixel);
      for (std::size_t i = 0; i < count; ++i) out.insert(out.end(), one.begin(), one.end());
    }
  }
  out.resize(size);
  return out;
}

/// A row as packets: runs of equal pixels, and those between them as they are.
std::vector<std::uint8_t> pack(FileBytes row, std::size_t pixel) {
  constexpr std::size_t kMost = 128;
  const std::size_t count = row.size() / pixel;
  const auto are_equal = [&](std::size_t a, std::size_t b) {
    return std::memcmp(&row[a * pixel], &row[b * pixel], pixel) == 0;
  };
  std::vector<std::uint8_t> out;
  for (std::size_t first = 0; first < count;) {
    std::size_t end = first + 1;
    while (end < count && end - first < kMost && are_equal(first, end)) ++end;
    const bool is_run = end - first > 1;
    if (!is_run) {
      while (end < count && end - first < kMost && (end + 1 == count || !are_equal(end, end + 1))) ++end;
    }
    out.push_back(static_cast<std::uint8_t>((end - first - 1) | (is_run ? 0x80 : 0)));
    const FileBytes pixels = row.subspan(first * pixel, (is_run ? 1 : end - first) * pixel);
    out.insert(out.end(), pixels.begin(), pixels.end());
    first = end;
  }
  return out;
}

/// One pixel or colour of the palette: its samples in the order of Raster. As in POV-Ray, the sixteenth and the last
/// eight of 32 bits are alpha, whatever the header says of them.
void put_color(const std::uint8_t* from, int bits, std::uint8_t* to) {
  if (bits <= 16) {
    const int all = word(from);
    to[0] = static_cast<std::uint8_t>(all >> 10 & 31);
    to[1] = static_cast<std::uint8_t>(all >> 5 & 31);
    to[2] = static_cast<std::uint8_t>(all & 31);
    if (bits == 16) to[3] = (all & 0x8000) != 0 ? 31 : 0;
  } else {
    to[0] = from[2];
    to[1] = from[1];
    to[2] = from[0];
    if (bits == 32) to[3] = from[3];
  }
}

std::vector<Raster::Color> palette_of(FileBytes data, const Header& header) {
  const std::size_t size = bytes_of(header.palette_bits);
  std::vector<Raster::Color> palette(static_cast<std::size_t>(header.palette_length));
  for (std::size_t i = 0; i < palette.size(); ++i) {
    Raster::Color& color = palette[i];
    const bool few = header.palette_bits <= 16;
    color[3] = few ? 31 : 255;
    put_color(data.data() + i * size, header.palette_bits, color.data());
    for (std::uint8_t& sample : color) {
      if (few) sample = static_cast<std::uint8_t>((sample * 255 + 15) / 31);
    }
  }
  return palette;
}

int channels_of(const Header& header) {
  if (header.kind == Kind::palette) return 1;
  if (header.kind == Kind::grey) return header.bits == 16 ? 2 : 1;
  return header.bits == 16 || header.bits == 32 ? 4 : 3;
}

}  // namespace

bool is_tga(FileBytes file) {
  if (file.size() < kHeaderSize) return false;
  if (file.size() >= kHeaderSize + kSignature.size() &&
      std::memcmp(file.last(kSignature.size()).data(), kSignature.data(), kSignature.size()) == 0) {
    return true;
  }
  const Header header = header_of(file);
  const std::array<std::uint8_t, 5> nothing{};
  const bool palette_is_right =
      header.has_palette ? is_color(header.palette_bits) : std::equal(nothing.begin(), nothing.end(), &file[3]);
  return file[1] <= 1 && file[2] <= 11 && palette_is_right && is_known(header) && !header.interleaved &&
         header.width > 0 && header.height > 0;
}

Raster read_tga(FileBytes file) {
  if (file.size() < kHeaderSize) throw BrokenPicture(kEndsTooEarly);
  const Header header = header_of(file);
  if (!is_known(header) || header.interleaved || file[2] > 11)
    throw BrokenPicture("it is of no kind that TGA files are of");
  FileBytes data = file.subspan(kHeaderSize);
  const std::size_t pixel = bytes_of(header.bits);
  // A run of 128 pixels is a byte and a pixel.
  check_size(header.width, header.height, data.size(), 128);
  const std::size_t palette_size =
      header.has_palette ? static_cast<std::size_t>(header.palette_length) * bytes_of(header.palette_bits) : 0;
  if (data.size() < header.id_length + palette_size) throw BrokenPicture(kEndsTooEarly);
  data = data.subspan(header.id_length);

  Raster raster;
  raster.width = header.width;
  raster.height = header.height;
  raster.channels = channels_of(header);
  if (header.kind == Kind::palette) raster.palette = palette_of(data, header);
  if (header.kind == Kind::color && header.bits <= 16) raster.white = 31;
  const std::size_t width = static_cast<std::size_t>(header.width);
  const std::size_t height = static_cast<std::size_t>(header.height);
  const std::size_t channels = static_cast<std::size_t>(raster.channels);
  const std::vector<std::uint8_t> pixels =
      unpack(data.subspan(palette_size), header.runs, pixel, width * height * pixel);

  // Calls place(pixel of the file, number of the raster's pixel) for each.
  const auto for_each_pixel = [&](const auto& place) {
    const std::uint8_t* from = pixels.data();
    for (std::size_t row = 0; row < height; ++row) {
      const std::size_t y = header.from_top ? row : height - 1 - row;
      for (std::size_t column = 0; column < width; ++column, from += pixel) {
        place(from, y * width + (header.from_right ? width - 1 - column : column));
      }
    }
  };
  if (header.kind == Kind::palette) {
    Raster::Words& indices = raster.samples.emplace<Raster::Words>(width * height);
    for_each_pixel([&](const std::uint8_t* from, std::size_t to) {
      const int index = (pixel == 1 ? from[0] : word(from)) - header.palette_first;
      if (index < 0 || index >= header.palette_length) throw BrokenPicture("a pixel's index is beyond the palette");
      indices[to] = static_cast<std::uint16_t>(index);
    });
  } else {
    Raster::Bytes& samples = raster.samples.emplace<Raster::Bytes>(width * height * channels);
    for_each_pixel([&](const std::uint8_t* from, std::size_t to) {
      if (header.kind == Kind::grey) {
        std::copy_n(from, channels, &samples[to * channels]);
      } else {
        put_color(from, header.bits, &samples[to * channels]);
      }
    });
  }
  return raster;
}

void make_tga(const PictureRows& picture, const PutBytes& put) {
  const int width = picture.width;
  const int height = picture.height;
  if (std::max(width, height) > 65535) throw BrokenPicture("a TGA file has at most 65535 pixels each way");
  const bool has_alpha = picture.has_alpha();
  const std::size_t pixel = picture.pixel_bytes();
  std::vector<std::uint8_t> bytes(kHeaderSize);
  bytes[2] = static_cast<std::uint8_t>(static_cast<int>(Kind::color) | (picture.runs ? kRuns : 0));
  bytes[12] = static_cast<std::uint8_t>(width & 255);
  bytes[13] = static_cast<std::uint8_t>(width >> 8);
  bytes[14] = static_cast<std::uint8_t>(height & 255);
  bytes[15] = static_cast<std::uint8_t>(height >> 8);
  bytes[16] = has_alpha ? 32 : 24;
  bytes[17] = has_alpha ? kFromTop | 8 : kFromTop;
  put(bytes);
  bytes.resize(picture.row_bytes());
  for (int y = 0; y < height; ++y) {
    picture.make(y, bytes);
    for (std::size_t x = 0; x < bytes.size(); x += pixel) std::swap(bytes[x], bytes[x + 2]);
    put(picture.runs ? pack(bytes, pixel) : bytes);
  }
  bytes.assign(8, 0);  // two offsets, of nothing
  bytes.insert(bytes.end(), kSignature.begin(), kSignature.end());
  put(bytes);
}

}  // namespace firstlight::render
