#pragma once

#include "render/shape/shape.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// A landscape over the unit square, as high as numbers on a grid say. [POV-Ray 3.7 manual, "Height Field"]
struct HeightFieldParameters {
  int columns = 2;  ///< at least 2 each
  int rows = 2;
  std::vector<std::uint16_t> heights;  ///< of 65536; along x, then along z
  double water_level = 0.0;            ///< from 0 to 1; what is below is left out
  bool smooth = false;                 ///< normals are interpolated
};

/// All that lies below the water is inside, without end.
ShapePtr make_height_field(HeightFieldParameters parameters);
bool is_height_field(const Shape& shape);

}  // namespace firstlight::render
