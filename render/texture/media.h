#pragma once

#include "render/feature/feature.h"
#include "render/math/color.h"
#include "render/texture/patterning.h"
#include "render/texture/pigment.h"

#include <memory>
#include <vector>

namespace firstlight::render {

struct Density;
using DensityMap = BlendMap<Density>;

/// How thick a medium is from place to place, each colour by itself; 1 everywhere while nothing is said.
struct Density {
  FilteredColor color = {};  ///< of PatternKind::plain
  Patterning pattern = {};
  ColorMap map = {};                                 ///< empty: grey from 0 to 1
  std::shared_ptr<const DensityMap> densities = {};  ///< instead of `map`
};

/// Matter that glows, dims or scatters light in space. Plain data; defaults are POV-Ray 3.7's.
/// Source   POV-Ray 3.7 manual, "Media".
struct Media {
  enum class Scattering { isotropic = 1, mie_hazy, mie_murky, rayleigh, henyey_greenstein };

  Rgb absorption{0.0f, 0.0f, 0.0f};
  Rgb emission{0.0f, 0.0f, 0.0f};
  Rgb scattering{0.0f, 0.0f, 0.0f};
  Scattering scattering_type = Scattering::isotropic;
  double eccentricity = 0.0;
  double extinction = 1.0;
  std::vector<Density> densities = {};  ///< multiplied

  // How it is sampled.
  int method = 3;
  int intervals = 1;
  int least_samples = 10;
  int most_samples = 10;
  double confidence = 0.9;
  double variance = 1.0 / 128.0;
  double ratio = 0.9;
  double aa_threshold = 0.1;
  int aa_level = 3;
  double jitter = 0.0;
  bool collects_photons = true;

  FeatureUses unrendered = {};
};

/// Moves the densities on.
void move(Media& media, const Transform& transform);
/// Adds what the medium, or a density, asks for that cannot be rendered.
void gather(const Density& density, FeatureUses& uses);
void gather(const Media& media, FeatureUses& uses);

}  // namespace firstlight::render
