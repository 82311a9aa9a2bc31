#pragma once

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// A picture as an 8-bit file holds it: red green blue of each pixel, rows from the top.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  bool operator==(const Picture&) const = default;
};

}  // namespace firstlight::render
