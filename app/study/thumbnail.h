#pragma once

#include "render/image/image_io.h"
#include "render/math/color.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::app {

/// A picture made smaller: each pixel is the mean of those it stands for.
struct SmallPicture {
  int width = 0;
  int height = 0;
  std::vector<render::Rgb> colors;
};
/// As large as fits into `most` by `most` pixels, never larger than it is.
SmallPicture shrink(std::span<const render::Rgb> colors, int width, int height, int most);

/// The bytes of a file in the letters of a data URI. Source: RFC 4648, section 4.
std::string base64(std::string_view bytes);

}  // namespace firstlight::app
