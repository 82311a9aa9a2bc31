#pragma once

#include "render/feature/feature.h"
#include "render/math/color.h"
#include "render/math/transform.h"
#include "render/math/vec.h"
#include "render/texture/media.h"
#include "render/texture/pigment.h"

#include <memory>
#include <optional>
#include <vector>

namespace firstlight::render {

/// Source   POV-Ray 3.7 manual, "Fog".
struct FogTurbulence {
  Vec3 amount{0.0, 0.0, 0.0};
  int octaves = 6;
  double omega = 0.5;
  double lambda = 2.0;
};

/// Source   POV-Ray 3.7 manual, "Fog".
struct Fog {
  static constexpr int kConstant = 1;
  static constexpr int kGround = 2;

  int type = kConstant;
  double distance = 0.0;  ///< at which 1/e of the light is left; 0: no fog
  FilteredColor color;
  double altitude = 0.0;   ///< of ground fog: above `offset`, where a quarter of its density is left
  double offset = 0.0;     ///< of ground fog: below it the density is constant
  Vec3 up{0.0, 1.0, 0.0};  ///< unit length
  std::optional<FogTurbulence> turbulence;
  double turbulence_depth = 0.5;
  FeatureUses unrendered = {};
};

/// Source   POV-Ray 3.7 manual, "Rainbow".
struct Rainbow {
  Vec3 direction{0.0, 0.0, 0.0};  ///< in which the light goes; unit length
  Vec3 up{0.0, 1.0, 0.0};         ///< unit length, at right angles to `direction`
  double angle = 0.0;             ///< degrees, from the direction to the middle of the bow
  double width = 0.0;             ///< degrees
  double distance = 1e7;          ///< scene units
  double jitter = 0.0;
  /// Radians from the top of the bow to where it ends, and to where it begins to fade. POV-Ray's default is far more
  /// than a full turn.
  double arc_half_angle = 180.0;
  double falloff_half_angle = 180.0;
  ColorMap colors;  ///< from the inside to the outside
  FeatureUses unrendered = {};

  bool shows() const { return !colors.empty() && distance != 0.0 && width != 0.0; }
};

/// Colours of the directions that meet nothing. Source   POV-Ray 3.7 manual, "Sky Sphere".
struct SkySphere {
  std::vector<Pigment> pigments;  ///< of points of the unit sphere, the last one topmost
  Rgb emission{1.0f, 1.0f, 1.0f};
  Transform placement;
  FeatureUses unrendered = {};
};

/// Surroundings of the objects.
struct Atmosphere {
  std::vector<Fog> fogs;          ///< in the order of the scene text
  std::vector<Rainbow> rainbows;  ///< the same
  std::vector<Media> media;       ///< where no object is, or a hollow one
  std::shared_ptr<const SkySphere> sky_sphere;
};

}  // namespace firstlight::render
