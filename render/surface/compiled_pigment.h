#pragma once

#include "render/surface/compiled_pattern.h"
#include "render/texture/pigment.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// Colours side by side.
struct ColorColumns {
  Columns3<float> rgb;
  Column<float> filter;
  Column<float> transmit;
  std::uint64_t missing =
      0;  ///< bits of the points at which the pigment has nothing: beside a picture that is laid on once

  void set(std::size_t i, const FilteredColor& color) {
    rgb.set(i, color.rgb);
    filter[i] = color.filter;
    transmit[i] = color.transmit;
  }
  FilteredColor color(std::size_t i) const { return {rgb.vector(i), filter[i], transmit[i]}; }
};

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
  std::vector<CompiledPigment> entries_;  ///< of a map of pigments
};

}  // namespace firstlight::render
