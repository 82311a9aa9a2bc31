#pragma once

#include "render/surface/compiled_pigment.h"
#include "render/texture/patterns.h"

#include <optional>
#include <utility>

namespace firstlight::render {

/// A pattern that is asked point by point.
class AskedPattern {
 public:
  explicit AskedPattern(PatternKind kind, const PatternParameters& parameters = {}, int noise_generator = 2,
                        const std::optional<Turbulence>& turbulence = {})
      : pattern_(make_pattern(kind, {parameters, noise_generator, PatternWorld(), turbulence})) {}

  bool is_made() const { return pattern_ != nullptr; }
  double value(const Vec3& point) const {
    SurfacePoints points;
    points.size = 1;
    Columns3<double> at;
    at.set(0, point);
    Column<double> values;
    pattern_->values(at, points, values);
    return values[0];
  }

 private:
  PatternPtr pattern_;
};

inline FilteredColor color_at(const Pigment& pigment, const Vec3& point) {
  return CompiledPigment(pigment, PatternWorld()).color_at(point);
}

}  // namespace firstlight::render
