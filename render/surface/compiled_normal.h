#pragma once

#include "render/surface/compiled_pattern.h"
#include "render/surface/normal_space.h"
#include "render/texture/normal.h"

#include <vector>

namespace firstlight::render {

/// A normal ready to tilt.
///
/// Source   POV-Ray 3.7: patterns with tilts of their own add them; of all others the normal gets the slope between the
///          values at four corners of a small tetrahedron.
/// Threads  Immutable. The Normal must outlive it.
class CompiledNormal {
 public:
  /// `keeps_length`: no_bump_scale of all that it is part of.
  CompiledNormal(const Normal& source, const PatternWorld& world, bool keeps_length);

  bool keeps_length() const { return keeps_length_; }
  /// Tilts `normals`, one for each of `points`, which are given in the space that the normal is placed in.
  /// `placement`: from the normals' space to that one, null where they are in that space already.
  void tilt(const SurfacePoints& points, const Transform* placement, Columns3<double>& normals) const;

 private:
  void tilt_by_map(const SurfacePoints& points, const Columns3<double>& there, Columns3<double>& normals) const;
  void tilt_by_average(const SurfacePoints& points, const Columns3<double>& there, Columns3<double>& normals) const;
  void tilt_by_heights(const SurfacePoints& points, const Columns3<double>& there, Columns3<double>& normals) const;
  double height(double value) const;

  const Normal* source_;
  CompiledPattern pattern_;
  double amount_;  ///< POV-Ray keeps it in single precision
  bool keeps_length_;
  std::vector<CompiledNormal> entries_;  ///< of a map of normals
};

}  // namespace firstlight::render
