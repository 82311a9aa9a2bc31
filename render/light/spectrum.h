#pragma once

#include "render/math/color.h"

#include <cstdint>

namespace firstlight::render {

/// A part of the spectrum, of so many equally wide ones from violet to red; or all of it.
/// Source   POV-Ray 3.7's dispersion.
struct SpectralBand {
  std::uint16_t number = 0;  ///< from 0 on
  std::uint16_t count = 0;   ///< 0: white light, which has not been split

  bool is_white() const { return count == 0; }
};

/// The band's part of white light, times the number of bands. That of all bands together is white, but for what lies beyond
/// the spectrum's ends. Pre: not white.
Rgb hue(SpectralBand band);

/// The index by which light of the band is bent, of matter whose index for the middle of the spectrum is `ior` and whose
/// indices for violet and red have the ratio `dispersion`; or the same of two kinds of matter, as ratios. Pre: not white.
double dispersed_ior(double ior, double dispersion, SpectralBand band);

}  // namespace firstlight::render
