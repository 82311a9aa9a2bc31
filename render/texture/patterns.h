#pragma once

#include "render/texture/pattern.h"
#include "render/texture/pattern_parameters.h"

#include <memory>

namespace firstlight::render {

using PatternPtr = std::shared_ptr<const Pattern>;

// Makers of the patterns that are evaluated. Values are POV-Ray 3.7's. What disturbs a pattern, turbulence and warps,
// is not their part.

/// Rises by one with every unit of way along `axis`, whose own length does not matter. Zero everywhere for a zero axis.
PatternPtr make_gradient(const Vec3& axis);
/// The x coordinate itself.
PatternPtr make_marble();

// From 1 at the origin (boxed: by the largest coordinate; spherical), the y axis (cylindrical) or the xz plane (planar)
// down to 0 one unit away.
PatternPtr make_boxed();
PatternPtr make_cylindrical();
PatternPtr make_planar();
PatternPtr make_spherical();
/// Shells one unit thick.
PatternPtr make_onion();
PatternPtr make_leopard();
/// The angle about the y axis.
PatternPtr make_radial();
/// Bulges in unit cubes.
PatternPtr make_quilted(const QuiltedParameters& parameters);

/// The distance from the z axis.
PatternPtr make_wood();
PatternPtr make_spiral1(const SpiralParameters& parameters);
PatternPtr make_spiral2(const SpiralParameters& parameters);

PatternPtr make_fractal(const FractalParameters& parameters);

// List patterns: their values are places in a list.
PatternPtr make_brick(const BrickParameters& parameters);
/// Unit cubes, by turns 0 and 1.
PatternPtr make_checker();
PatternPtr make_cubic();
PatternPtr make_hexagon();
PatternPtr make_square();
PatternPtr make_triangular();

}  // namespace firstlight::render
