// Patterns that turbulence shapes in a way of their own: agate, marble, wood, and the spirals.

#include "render/texture/lane_field.h"
#include "render/texture/patterns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/texture/pattern_turbulent.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/math-inl.h"
#include "render/math/noise-inl.h"
#include "render/texture/lane_field-inl.h"
#include "render/texture/wave-inl.h"

#include <variant>

#ifndef FIRSTLIGHT_RENDER_TEXTURE_PATTERN_TURBULENT
#define FIRSTLIGHT_RENDER_TEXTURE_PATTERN_TURBULENT
namespace firstlight::render {
namespace {

/// Bands along z that turbulence of the pattern's own strength disturbs; the word `turbulence` says how fine it is.
struct Agate {
  double strength;
  Octaves octaves;
  int generator;
};
/// The x coordinate itself, which turbulence moves by a sum of noise instead of moving the point.
struct Marble {
  double strength;
  Octaves octaves;
  int generator;
};
/// The distance from the z axis. Turbulence swings the rings to and fro, by waves of its own strength.
struct Wood {
  Vec3 amount;
  Octaves octaves;
};
/// Turns about the z axis, and the way along and from it, which turbulence adds to without moving the point.
struct Spiral {
  int arms;
  bool is_folded;  ///< to and fro, as spiral2 is, which adds rings to it
  double strength;
  Octaves octaves;
  int generator;
};

using TurbulentFormula = std::variant<Agate, Marble, Wood, Spiral>;

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE L value(const Agate& agate, const Vec3Of<L>& p) {
  const L disturbed = agate.strength * turbulence(p, agate.octaves, agate.generator);
  const L band = 0.5 * (sine_wave(1.3 * disturbed + 1.1 * p.z) + 1.0);
  return select(band < 0.0, L(0.0), power(min(L(1.0), band), L(0.77)));
}

template <class L>
HWY_INLINE L value(const Marble& marble, const Vec3Of<L>& p) {
  if (marble.strength == 0.0) return p.x;
  return p.x + marble.strength * turbulence(p, marble.octaves, marble.generator);
}

template <class L>
HWY_INLINE L from_axis(const L& x, const L& y) {
  return sqrt(x * x + y * y);
}
template <class L>
HWY_INLINE L value(const Wood& wood, const Vec3Of<L>& p) {
  if (wood.octaves.count == 0) return from_axis(p.x, p.y);
  const Vec3Of<L> shift = dturbulence(p, wood.octaves);
  return from_axis(sine_wave((p.x + shift.x) * wood.amount.x) + p.x, sine_wave((p.y + shift.y) * wood.amount.y) + p.y);
}

/// Turns about the z axis, 0 to 1, from -y by x to y and on. 0 on the axis.
template <class L>
HWY_INLINE L turns_about_z(const Vec3Of<L>& p, const L& radius) {
  constexpr double kPi = kPiHigh;
  const L rise = arc_sine(p.y / radius);
  const L turns = select(p.x < 0.0, 1.5 * kPi - rise, 0.5 * kPi + rise) / (2.0 * kPi);
  return select(radius == 0.0, L(0.0), turns);
}
template <class L>
HWY_INLINE L value(const Spiral& spiral, const Vec3Of<L>& p) {
  const L radius = from_axis(p.x, p.y);
  L sum = p.z + radius + L(spiral.arms) * turns_about_z(p, radius);
  if (spiral.strength != 0.0) sum = sum + spiral.strength * turbulence(p, spiral.octaves, spiral.generator);
  return spiral.is_folded ? triangle_wave(radius) + triangle_wave(sum) : sum;
}

void turbulent_values(const TurbulentFormula& formula, const Columns3<double>& at, std::size_t count,
                      Column<double>& values) {
  std::visit([&](const auto& f) { values_at(f, at, count, values); }, formula);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(turbulent_values);

PatternPtr make_turbulent(const TurbulentFormula& formula) {
  return make_lane_field(
      formula, [](const TurbulentFormula& f, const Columns3<double>& at, std::size_t count, Column<double>& values) {
        HWY_DYNAMIC_DISPATCH(turbulent_values)(f, at, count, values);
      });
}

PatternPtr make_spiral(const PatternRequest& request, bool is_folded) {
  Spiral spiral{request.get<SpiralParameters>().arms, is_folded, 0.0, {}, request.noise_generator};
  if (request.turbulence) {
    spiral.strength = request.turbulence->amount.x;
    spiral.octaves = octaves_of(*request.turbulence);
  }
  return make_turbulent(spiral);
}

}  // namespace

PatternPtr pattern::make_agate(const PatternRequest& request) {
  const double strength = static_cast<float>(request.get<AgateParameters>().turbulence);
  const Octaves octaves = request.turbulence ? octaves_of(*request.turbulence) : Octaves();
  return make_turbulent(Agate{strength, octaves, request.noise_generator});
}

PatternPtr pattern::make_marble(const PatternRequest& request) {
  if (!request.turbulence) return make_turbulent(Marble{0.0, {}, request.noise_generator});
  return make_turbulent(Marble{request.turbulence->amount.x, octaves_of(*request.turbulence), request.noise_generator});
}

PatternPtr pattern::make_wood(const PatternRequest& request) {
  if (!request.turbulence) return make_turbulent(Wood{Vec3(0.0), {0, 0.0f, 0.0f}});
  return make_turbulent(Wood{request.turbulence->amount, octaves_of(*request.turbulence)});
}

PatternPtr pattern::make_spiral1(const PatternRequest& request) { return make_spiral(request, false); }
PatternPtr pattern::make_spiral2(const PatternRequest& request) { return make_spiral(request, true); }

}  // namespace firstlight::render
#endif
