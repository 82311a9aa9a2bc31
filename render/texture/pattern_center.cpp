// Patterns that depend on where a point lies from the origin or an axis.

#include "render/texture/field.h"
#include "render/texture/patterns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

/// From 1 at distance 0 down to 0 at 1 and beyond.
double closeness(double distance) { return std::max(1.0 - distance, 0.0); }

/// Nearer to the y axis than this, an angle about it has no meaning. [POV-Ray 3.7]
constexpr double kAxis = 0.001;

double radial(const Vec3& p) {
  if (std::abs(p.x) < kAxis && std::abs(p.z) < kAxis) return 0.25;
  return 0.25 + (std::atan2(p.x, p.z) + std::numbers::pi) / (2.0 * std::numbers::pi);
}

double leopard(const Vec3& p) {
  const double mean = (std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3.0;
  return mean * mean;
}

/// A cubic Bezier curve from 0 to 1 with the two controls between, stretched so that the corners of a unit cube,
/// sqrt(3)/2 from its middle, come to 1. [POV-Ray 3.7]
double quilt(double t, const QuiltedParameters& controls) {
  const double rest = 1.0 - t;
  const double control0 = static_cast<float>(controls.control0), control1 = static_cast<float>(controls.control1);
  const double curve = t * t * t + 3.0 * t * (rest * rest) * control0 + 3.0 * (t * t) * rest * control1;
  return curve * (2.0 / std::numbers::sqrt3);
}

}  // namespace

PatternPtr pattern::make_boxed(const PatternRequest&) {
  return make_field([](const Vec3& p) { return closeness(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)})); });
}

PatternPtr pattern::make_cylindrical(const PatternRequest&) {
  return make_field([](const Vec3& p) { return closeness(std::sqrt(p.x * p.x + p.z * p.z)); });
}

PatternPtr pattern::make_planar(const PatternRequest&) {
  return make_field([](const Vec3& p) { return closeness(std::abs(p.y)); });
}

PatternPtr pattern::make_spherical(const PatternRequest&) {
  return make_field([](const Vec3& p) { return closeness(std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z)); });
}

PatternPtr pattern::make_onion(const PatternRequest&) {
  return make_field([](const Vec3& p) { return std::fmod(std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z), 1.0); });
}

PatternPtr pattern::make_leopard(const PatternRequest&) { return make_field(leopard); }

PatternPtr pattern::make_radial(const PatternRequest&) { return make_field(radial); }

PatternPtr pattern::make_quilted(const PatternRequest& request) {
  const auto bulge = [parameters = request.get<QuiltedParameters>()](const Vec3& p) {
    const auto from_middle = [](double x) { return x - std::floor(x) - 0.5; };
    const Vec3 cell(from_middle(p.x), from_middle(p.y), from_middle(p.z));
    return cell * quilt(std::sqrt(cell.x * cell.x + cell.y * cell.y + cell.z * cell.z), parameters);
  };
  return make_field(
      [bulge](const Vec3& p) {
        const Vec3 b = bulge(p);
        return (std::abs(b.x) + std::abs(b.y) + std::abs(b.z)) / 3.0;
      },
      [bulge](const Vec3& p, const Tilting& tilting) { return bulge(p) * tilting.amount; });
}

}  // namespace firstlight::render
