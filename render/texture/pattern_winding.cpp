// Patterns that wind about the z axis, and the rings of wood.

#include "render/texture/field.h"
#include "render/texture/patterns.h"

#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

double from_axis(const Vec3& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

/// Turns about the z axis, 0 to 1, from -y by x to y and on. 0 on the axis.
double turns(const Vec3& p, double radius) {
  using std::numbers::pi;
  if (radius == 0.0) return 0.0;
  const double rise = std::asin(p.y / radius);
  return (p.x < 0.0 ? 1.5 * pi - rise : 0.5 * pi + rise) / (2.0 * pi);
}

/// Up from 0 to 1 and down again within a period of 1.
double triangle(double value) {
  const double along = value - std::floor(value);
  return along >= 0.5 ? 2.0 * (1.0 - along) : 2.0 * along;
}

}  // namespace

PatternPtr make_spiral1(const SpiralParameters& parameters) {
  return make_field([parameters](const Vec3& p) {
    const double radius = from_axis(p);
    return p.z + radius + parameters.arms * turns(p, radius);
  });
}

PatternPtr make_spiral2(const SpiralParameters& parameters) {
  return make_field([parameters](const Vec3& p) {
    const double radius = from_axis(p);
    return triangle(radius) + triangle(p.z + radius + parameters.arms * turns(p, radius));
  });
}

PatternPtr make_wood() { return make_field(from_axis); }

}  // namespace firstlight::render
