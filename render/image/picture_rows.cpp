#include "render/image/picture_rows.h"

#include <algorithm>

namespace firstlight::render {

PictureRows rows_of(const Picture& picture) { return rows_of(picture.width, picture.height, picture.rgb); }

PictureRows rows_of(int width, int height, std::span<const std::uint8_t> rgb) {
  return {width, height, [rgb](int y, std::span<std::uint8_t> row) {
            std::ranges::copy(rgb.subspan(static_cast<std::size_t>(y) * row.size(), row.size()), row.begin());
          }};
}

std::vector<std::uint8_t> whole(const PictureRows& rows) {
  const std::size_t row = rows.row_bytes();
  std::vector<std::uint8_t> bytes(row * static_cast<std::size_t>(rows.height));
  for (int y = 0; y < rows.height; ++y) rows.make(y, std::span(bytes).subspan(row * static_cast<std::size_t>(y), row));
  return bytes;
}

}  // namespace firstlight::render
