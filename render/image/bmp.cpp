// Windows' bitmaps, only written here. Source: the structures BITMAPFILEHEADER and BITMAPINFOHEADER; alpha as the
// fourth byte is read by few programs, POV-Ray among them.

#include "render/image/file_formats.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

void put_number(std::vector<std::uint8_t>& bytes, std::uint64_t number, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(i < 8 ? static_cast<std::uint8_t>(number >> (8 * i) & 255) : 0);
}

}  // namespace

void make_bmp(const PictureRows& picture, const PutBytes& put) {
  constexpr std::uint64_t kHeader = 14;
  constexpr std::uint64_t kDescription = 40;
  const std::size_t pixel = picture.pixel_bytes();
  const std::size_t row = (picture.row_bytes() + 3) / 4 * 4;
  const std::uint64_t size = std::uint64_t{row} * static_cast<std::uint64_t>(picture.height);
  if (size > UINT32_MAX - kHeader - kDescription) throw BrokenPicture("a BMP file has at most 4 GB");
  std::vector<std::uint8_t> bytes{'B', 'M'};
  put_number(bytes, kHeader + kDescription + size, 4);
  put_number(bytes, 0, 4);
  put_number(bytes, kHeader + kDescription, 4);
  put_number(bytes, kDescription, 4);
  put_number(bytes, static_cast<std::uint64_t>(picture.width), 4);
  put_number(bytes, static_cast<std::uint64_t>(picture.height), 4);
  put_number(bytes, 1, 2);  // plane
  put_number(bytes, 8 * pixel, 2);
  put_number(bytes, 0, 4);  // as they are
  put_number(bytes, size, 4);
  put_number(bytes, 0, 16);  // nothing is said of its size in metres and of palettes
  put(bytes);
  bytes.assign(row, 0);
  for (int y = picture.height - 1; y >= 0; --y) {
    picture.make(y, std::span(bytes).first(picture.row_bytes()));
    for (std::size_t x = 0; x < picture.row_bytes(); x += pixel) std::swap(bytes[x], bytes[x + 2]);
    put(bytes);
  }
}

}  // namespace firstlight::render
