#pragma once

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// A picture as an 8-bit file holds it: red green blue of each pixel, rows from the top, not multiplied by alpha.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
  std::vector<std::uint8_t> alpha = {};  ///< of each pixel; empty: all are opaque

  bool operator==(const Picture&) const = default;
};

}  // namespace firstlight::render
