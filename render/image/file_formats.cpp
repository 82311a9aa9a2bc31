#include "render/image/file_formats.h"

namespace firstlight::render {

void check_size(std::int64_t width, std::int64_t height, std::size_t bytes, std::int64_t pixels_a_byte) {
  constexpr std::int64_t kLongest = std::int64_t{1} << 28;  // so that no product below is too large
  if (width <= 0 || height <= 0 || width > kLongest || height > kLongest || width * height > kMostPixels) {
    throw BrokenPicture(kNoSize);
  }
  if (width * height / pixels_a_byte > static_cast<std::int64_t>(bytes)) throw BrokenPicture(kEndsTooEarly);
}

}  // namespace firstlight::render
