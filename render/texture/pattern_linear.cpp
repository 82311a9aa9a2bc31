// Patterns that grow in step with a coordinate.

#include "render/texture/field.h"
#include "render/texture/patterns.h"

#include <cmath>

namespace firstlight::render {

/// Rises by one with every unit of way along an axis, whose own length does not matter. Zero everywhere for a zero axis.
/// Only values above 1 are folded back: 1 itself stays, so the far end of a unit gradient keeps its last colour, and
/// negative values are left to the wave, which folds them upwards. [POV-Ray 3.7]
PatternPtr pattern::make_gradient(const PatternRequest& request) {
  const Vec3& axis = request.get<GradientParameters>().axis;
  const double length = axis.length();
  return make_field([unit = length > 0.0 ? axis / length : axis](const Vec3& point) {
    const double along = point.dot(unit);
    return along > 1.0 ? std::fmod(along, 1.0) : along;
  });
}

}  // namespace firstlight::render
