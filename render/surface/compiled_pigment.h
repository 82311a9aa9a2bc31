#pragma once

#include "render/surface/color_columns.h"
#include "render/surface/color_map_table.h"
#include "render/surface/compiled_pattern.h"
#include "render/texture/pigment.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// A pigment ready to be asked for colours.
///
/// Source   POV-Ray 3.7: colours between entries are blended in single precision.
/// Threads  Immutable. The Pigment must outlive it.
class CompiledPigment {
 public:
  CompiledPigment(const Pigment& source, const PatternWorld& world);

  /// Whether it is one colour everywhere.
  bool is_plain() const { return even_ != nullptr; }
  const Pigment& source() const { return *source_; }
  /// The colours at `points`, given in the space that the pigment is placed in.
  void colors(const SurfacePoints& points, ColorColumns& colors) const;
  /// At one point that is on no surface.
  FilteredColor color_at(const Vec3& point) const;

 private:
  void mapped(const SurfacePoints& points, ColorColumns& colors) const;
  void pictured(const SurfacePoints& points, ColorColumns& colors) const;
  void averaged(const SurfacePoints& points, ColorColumns& colors) const;
  void blended(const SurfacePoints& points, ColorColumns& colors) const;

  const Pigment* source_;
  const FilteredColor* even_;  ///< null: it is patterned
  CompiledPattern pattern_;
  ColorMapTable map_;                     ///< of a map of colours
  std::vector<CompiledPigment> entries_;  ///< of a map of pigments
};

}  // namespace firstlight::render
