#pragma once

#include "render/feature/feature.h"
#include "render/math/color.h"

namespace firstlight::render {

/// How a surface answers to light. Defaults are POV-Ray 3.7's for language version 3.7.
/// Source   POV-Ray 3.7 manual, "Finish".
struct Finish {
  Rgb ambient{0.1f, 0.1f, 0.1f};
  Rgb emission{0.0f, 0.0f, 0.0f};
  double diffuse = 0.6;
  double diffuse_back = 0.0;  ///< second number of `diffuse`: light from behind
  double brilliance = 1.0;
  double phong = 0.0;
  double phong_size = 40.0;
  double specular = 0.0;
  double roughness_exponent = 20.0;  ///< 1 / roughness
  double metallic = 0.0;             ///< tint of highlights, 0 to 1

  Rgb reflection_min{0.0f, 0.0f, 0.0f};
  Rgb reflection_max{0.0f, 0.0f, 0.0f};
  double reflection_falloff = 1.0;
  double reflection_metallic = 0.0;
  double reflection_exponent = 1.0;  ///< power applied to the reflected colour; 1 / the number in the scene
  bool reflection_fresnel = false;
  bool conserve_energy = false;

  double crand = 0.0;  ///< strength of random darkening
  double irid = 0.0;   ///< strength of the colours of a thin film
  double irid_thickness = 0.0;
  double irid_turbulence = 0.0;
  bool subsurface = false;
  Rgb subsurface_translucency{0.0f, 0.0f, 0.0f};
  Rgb subsurface_anisotropy{0.0f, 0.0f, 0.0f};

  FeatureUses unrendered = {};  ///< of crand, irid, subsurface, caustics

  // Old scenes put these into the finish; scene building moves them to the interior.
  double legacy_ior = 0.0;         ///< 0: not given
  double legacy_refraction = 1.0;  ///< factor on light that passes
  double legacy_caustics = -1.0;   ///< below 0: not given
};

/// Adds what the finish asks for that cannot be rendered.
void gather(const Finish& finish, FeatureUses& uses);

}  // namespace firstlight::render
