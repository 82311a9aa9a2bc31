// Patterns that wind about the z axis, and the rings of wood.

#include "render/math/noise.h"
#include "render/texture/field.h"
#include "render/texture/patterns.h"
#include "render/texture/wave.h"

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

/// What turbulence adds to the turns of a spiral; it does not move the point.
class Unrest {
 public:
  explicit Unrest(const PatternRequest& request) : generator_(request.noise_generator) {
    if (!request.turbulence) return;
    strength_ = request.turbulence->amount.x;
    octaves_ = octaves_of(*request.turbulence);
  }
  double at(const Vec3& p) const { return strength_ == 0.0 ? 0.0 : strength_ * turbulence(p, octaves_, generator_); }

 private:
  double strength_ = 0.0;
  Octaves octaves_;
  int generator_;
};

}  // namespace

PatternPtr pattern::make_spiral1(const PatternRequest& request) {
  return make_field([arms = request.get<SpiralParameters>().arms, unrest = Unrest(request)](const Vec3& p) {
    const double radius = from_axis(p);
    return p.z + radius + arms * turns(p, radius) + unrest.at(p);
  });
}

PatternPtr pattern::make_spiral2(const PatternRequest& request) {
  return make_field([arms = request.get<SpiralParameters>().arms, unrest = Unrest(request)](const Vec3& p) {
    const double radius = from_axis(p);
    return triangle_wave(radius) + triangle_wave(p.z + radius + arms * turns(p, radius) + unrest.at(p));
  });
}

/// The distance from the z axis. Turbulence swings the rings to and fro, by waves of its own strength.
PatternPtr pattern::make_wood(const PatternRequest& request) {
  if (!request.turbulence) return make_field(from_axis);
  return make_field(
      [amount = request.turbulence->amount, octaves = octaves_of(*request.turbulence)](const Vec3& p) {
        const Vec3 shift = dturbulence(p, octaves);
        const auto swung = [](double x, double by, double strength) { return sine_wave((x + by) * strength) + x; };
        return from_axis({swung(p.x, shift.x, amount.x), swung(p.y, shift.y, amount.y), 0.0});
      });
}

}  // namespace firstlight::render
