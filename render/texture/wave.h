#pragma once

#include "render/math/columns.h"

#include <cstddef>

namespace firstlight::render {

/// How a pattern's value becomes a place in the map. [POV-Ray 3.7 manual, "Wave Forms"]
enum class WaveForm { ramp, triangle, sine, scallop, cubic, poly };

struct Wave {
  WaveForm form = WaveForm::ramp;
  double exponent = 1.0;  ///< of poly_wave
  double frequency = 1.0;
  double phase = 0.0;
};

/// Makes places in the map of `count` bare values.
void shape_all(const Wave& wave, std::size_t count, Column<double>& values);

}  // namespace firstlight::render
