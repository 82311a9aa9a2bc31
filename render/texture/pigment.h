#pragma once

#include "render/math/color.h"
#include "render/math/transform.h"
#include "render/feature/feature.h"
#include "render/texture/pattern.h"

#include <memory>
#include <vector>

namespace firstlight::render {

/// How a pattern's value becomes a place in the colour map. [POV-Ray 3.7 manual, "Wave Forms"]
enum class WaveForm { ramp, triangle, sine, scallop, cubic, poly };

struct Wave {
  WaveForm form = WaveForm::ramp;
  double exponent = 1.0;  ///< of poly_wave
  double frequency = 1.0;
  double phase = 0.0;
};

struct ColorMapEntry {
  double position = 0.0;
  FilteredColor color;
};

/// Entries in rising order of position; colours between them are interpolated, beyond them they stay.
using ColorMap = std::vector<ColorMapEntry>;

/// Colour of a surface at a point: one colour, or a pattern through a colour map. Plain data.
struct Pigment {
  FilteredColor color;                     ///< used when there is no pattern
  std::shared_ptr<const Pattern> pattern;  ///< null for a solid colour
  bool stepped = false;  ///< a list pattern (checker): map positions are list places, no wave, no blending
  Wave wave;
  ColorMap map;
  FeatureUses unrendered = {};
  Transform placement;  ///< pattern space to the space of the texture
};

/// The pigment's colour at `point`, given in the space that the pigment is placed in.
FilteredColor color_at(const Pigment& pigment, const Vec3& point);

/// Whether the pigment lets light through anywhere.
bool lets_light_through(const Pigment& pigment);

}  // namespace firstlight::render
