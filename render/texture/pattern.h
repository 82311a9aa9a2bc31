#pragma once

#include "render/math/columns.h"
#include "render/math/vec.h"
#include "render/texture/wave.h"

#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// Points at which something of a surface is asked, side by side: colours, tilts, values of patterns. Points that lie
/// on no surface (those of a function, or of media) have no normal, direction and uv.
struct SurfacePoints {
  std::size_t size = 0;  ///< at most kRaysAtOnce
  bool on_surface = false;
  Columns3<double> at;         ///< in the space that what is asked is placed in
  Columns3<double> place;      ///< the same in the scene
  Columns3<double> normal;     ///< of the bare surface, unit, towards the ray's origin, in the scene
  Columns3<double> tilted;     ///< the same after the normals that were asked last
  Columns3<double> direction;  ///< of the ray, unit, in the scene
  Columns2<double> uv;         ///< the surface's own coordinates

  /// A bit for each point.
  std::uint64_t all() const { return size == 0 ? 0 : ~std::uint64_t{0} >> (kRaysAtOnce - size); }
};

/// How a pattern is asked to tilt normals.
struct Tilting {
  double amount = 0.0;
  Wave wave = {};
};

/// A scalar field over space that a pigment turns into colours, a normal into tilts; pure and immutable.
/// Source   Values are those of POV-Ray 3.7's pattern of the same name, before frequency, phase and wave form.
class Pattern {
 public:
  virtual ~Pattern() = default;

  /// values[i] at `at` i, a point of the pattern's own space, which stands for point i of `points`. `values` has room for
  /// points.size.
  virtual void values(const Columns3<double>& at, const SurfacePoints& points, Column<double>& values) const = 0;

  /// Whether the pattern tilts normals in a way of its own, by tilt(); else its values are taken as heights.
  virtual bool has_tilt() const { return false; }
  /// Adds to the normals, which are in the pattern's own space, of any length. Pre: has_tilt(), `at` as above.
  virtual void tilt(const Tilting&, const Columns3<double>& /*at*/, const SurfacePoints&, Columns3<double>&) const {}
};

}  // namespace firstlight::render
