#pragma once

#include "render/math/color.h"
#include "render/math/columns.h"

#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// A colour of each point of a block.
struct ColorColumns {
  Columns3<float> rgb;
  Column<float> filter;
  Column<float> transmit;
  std::uint64_t missing =
      0;  ///< bits of the points at which the pigment has nothing: beside a picture that is laid on once

  void set(std::size_t i, const FilteredColor& color) {
    rgb.set(i, color.rgb);
    filter[i] = color.filter;
    transmit[i] = color.transmit;
  }
  FilteredColor color(std::size_t i) const { return {rgb.vector(i), filter[i], transmit[i]}; }
};

}  // namespace firstlight::render
