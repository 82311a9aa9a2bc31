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

/// The place in the map for a bare value.
double shaped(const Wave& wave, double value);
/// The same in place for `count` values.
void shape_all(const Wave& wave, std::size_t count, Column<double>& values);

/// sin(2 pi value).
double sine_wave(double value);
/// Up from 0 to 1 and down again within a period of 1.
double triangle_wave(double value);

}  // namespace firstlight::render
