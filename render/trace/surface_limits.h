#pragma once

#include "render/scene/scene.h"
#include "render/surface/surface_table.h"
#include "render/trace/surroundings_limits.h"

#include <vector>

namespace firstlight::render {

/// How dark a reflection with an exponent is where the light it sees has no root: not a number, which POV-Ray shows as
/// black whatever else is there.
constexpr double kDarkness = 256.0;

/// One way in which a surface may answer a ray: the most it makes of light, of any channel.
/// Units    Of the light that comes to the surface, or of white.
struct SurfaceAnswer {
  /// factor * light ^ exponent, of a reflection with an exponent.
  struct Power {
    double factor = 0.0;
    double exponent = 1.0;
    bool may_be_dark = false;  ///< kDarkness, where the light has no root
  };

  double own = 0.0;       ///< its own light, and diffuse light and highlights of all lights at their brightest
  double mirrored = 0.0;  ///< share of what comes from where it mirrors
  std::vector<Power> sealed;
  double straight = 0.0;  ///< share of what comes from behind, to a ray that goes straight on
  double bent = 0.0;      ///< the same to a ray that is bent, or totally reflected

  /// All but what comes from behind, where mirrors see `incoming`.
  double from_this_side(double incoming) const;
};

/// The most that the surfaces of a scene may do to light: answers that others exceed may be left out.
///
/// Source   The formulas of shading (render/trace/shade.cpp), each term at its largest.
struct SurfaceLimits {
  /// `surfaces`: of the scene. `origins`: what holds the places where primary rays begin.
  SurfaceLimits(const Scene& scene, const SurfaceTable& surfaces, const Box3& origins);

  std::vector<SurfaceAnswer> answers;
  double background = 0.0;  ///< of rays that meet nothing, before veils
  VeilLimits veil;
  /// False where a term has no largest value; it then counts with a usual one.
  bool proven = true;
};

}  // namespace firstlight::render
