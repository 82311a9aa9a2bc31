// Patterns that grow in step with a coordinate.

#include "render/texture/field.h"
#include "render/texture/patterns.h"

#include <cmath>

namespace firstlight::render {
namespace {

class Gradient final : public Pattern {
 public:
  explicit Gradient(const Vec3& unit_axis) : axis_(unit_axis) {}

  /// Only values above 1 are folded back: 1 itself stays, so the far end of a unit gradient keeps its last colour, and
  /// negative values are left to the wave, which folds them upwards. [POV-Ray 3.7]
  double value(const Vec3& point) const override {
    const double along = point.dot(axis_);
    return along > 1.0 ? std::fmod(along, 1.0) : along;
  }

 private:
  Vec3 axis_;
};

}  // namespace

PatternPtr make_gradient(const Vec3& axis) {
  const double length = axis.length();
  return std::make_shared<Gradient>(length > 0.0 ? axis / length : axis);
}

PatternPtr make_marble() {
  return make_field([](const Vec3& point) { return point.x; });
}

}  // namespace firstlight::render
