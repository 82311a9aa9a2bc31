// Patterns that depend on where a point lies from the origin, an axis or a plane.

#include "render/math/single.h"
#include "render/texture/lane_field.h"
#include "render/texture/patterns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/texture/pattern_center.cpp"
#include <hwy/foreach_target.h>

#include "render/texture/lane_field-inl.h"
#include "render/texture/wave-inl.h"

#include <numbers>
#include <variant>

#ifndef FIRSTLIGHT_RENDER_TEXTURE_PATTERN_CENTER
#define FIRSTLIGHT_RENDER_TEXTURE_PATTERN_CENTER
namespace firstlight::render {
namespace {

struct Boxed {};
struct Cylindrical {};
struct Planar {};
struct Spherical {};
struct Onion {};
struct Leopard {};
struct Radial {};
struct Quilted {
  double control0, control1;
};
/// Rises by one with every unit of way along an axis, whose own length does not matter. Zero everywhere for a zero axis.
struct Gradient {
  Vec3 unit;
};

using CenterFormula = std::variant<Boxed, Cylindrical, Planar, Spherical, Onion, Leopard, Radial, Quilted, Gradient>;

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// From 1 at distance 0 down to 0 at 1 and beyond.
template <class L>
HWY_INLINE L closeness(const L& distance) {
  return max(1.0 - distance, 0.0);
}

template <class L>
HWY_INLINE L value(const Boxed&, const Vec3Of<L>& p) {
  return closeness(max(max(abs(p.x), abs(p.y)), abs(p.z)));
}
template <class L>
HWY_INLINE L value(const Cylindrical&, const Vec3Of<L>& p) {
  return closeness(sqrt(p.x * p.x + p.z * p.z));
}
template <class L>
HWY_INLINE L value(const Planar&, const Vec3Of<L>& p) {
  return closeness(abs(p.y));
}
template <class L>
HWY_INLINE L value(const Spherical&, const Vec3Of<L>& p) {
  return closeness(length(p));
}
template <class L>
HWY_INLINE L value(const Onion&, const Vec3Of<L>& p) {
  return fraction_towards_0(length(p));
}

template <class L>
HWY_INLINE L value(const Leopard&, const Vec3Of<L>& p) {
  const L mean = (sine(p.x) + sine(p.y) + sine(p.z)) / 3.0;
  return mean * mean;
}

template <class L>
HWY_INLINE L value(const Radial&, const Vec3Of<L>& p) {
  constexpr double kAxis = 0.001;  // nearer to the y axis than this, an angle about it has no meaning [POV-Ray 3.7]
  const L turn = 0.25 + (arc_tangent(p.x, p.z) + kPiHigh) / (2.0 * kPiHigh);
  return select((abs(p.x) < kAxis) & (abs(p.z) < kAxis), L(0.25), turn);
}

/// A cubic Bezier curve from 0 to 1 with the two controls between, stretched so that the corners of a unit cube,
/// sqrt(3)/2 from its middle, come to 1. [POV-Ray 3.7]
template <class L>
HWY_INLINE Vec3Of<L> bulge(const Quilted& quilted, const Vec3Of<L>& p) {
  const Vec3Of<L> cell = {p.x - floor(p.x) - 0.5, p.y - floor(p.y) - 0.5, p.z - floor(p.z) - 0.5};
  const L t = length(cell), rest = 1.0 - t;
  const L curve = t * t * t + 3.0 * t * (rest * rest) * quilted.control0 + 3.0 * (t * t) * rest * quilted.control1;
  return cell * (curve * (2.0 / std::numbers::sqrt3));
}
template <class L>
HWY_INLINE L value(const Quilted& quilted, const Vec3Of<L>& p) {
  const Vec3Of<L> b = bulge(quilted, p);
  return (abs(b.x) + abs(b.y) + abs(b.z)) / 3.0;
}
template <class L>
HWY_INLINE Vec3Of<L> tilt(const Quilted& quilted, const Vec3Of<L>& p, const Tilting& tilting) {
  return bulge(quilted, p) * L(tilting.amount);
}

/// Only values above 1 are folded back: 1 itself stays, so the far end of a unit gradient keeps its last colour, and
/// negative values are left to the wave, which folds them upwards. [POV-Ray 3.7]
template <class L>
HWY_INLINE L value(const Gradient& gradient, const Vec3Of<L>& p) {
  const L along = dot(p, everywhere<L>(gradient.unit));
  return select(along > 1.0, fraction_towards_0(along), along);
}

void center_values(const CenterFormula& formula, const Columns3<double>& at, std::size_t count,
                   Column<double>& values) {
  std::visit([&](const auto& f) { values_at(f, at, count, values); }, formula);
}

void center_tilts(const CenterFormula& formula, const Tilting& tilting, const Columns3<double>& at, std::size_t count,
                  Columns3<double>& normals) {
  if (const auto* quilted = std::get_if<Quilted>(&formula)) tilt_at(*quilted, tilting, at, count, normals);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(center_values);
HWY_EXPORT(center_tilts);

void values_of(const CenterFormula& formula, const Columns3<double>& at, std::size_t count, Column<double>& values) {
  HWY_DYNAMIC_DISPATCH(center_values)(formula, at, count, values);
}
void tilts_of(const CenterFormula& formula, const Tilting& tilting, const Columns3<double>& at, std::size_t count,
              Columns3<double>& normals) {
  HWY_DYNAMIC_DISPATCH(center_tilts)(formula, tilting, at, count, normals);
}

PatternPtr without_tilt(const CenterFormula& formula) { return make_lane_field(formula, values_of); }

}  // namespace

PatternPtr pattern::make_boxed(const PatternRequest&) { return without_tilt(Boxed()); }
PatternPtr pattern::make_cylindrical(const PatternRequest&) { return without_tilt(Cylindrical()); }
PatternPtr pattern::make_planar(const PatternRequest&) { return without_tilt(Planar()); }
PatternPtr pattern::make_spherical(const PatternRequest&) { return without_tilt(Spherical()); }
PatternPtr pattern::make_onion(const PatternRequest&) { return without_tilt(Onion()); }
PatternPtr pattern::make_leopard(const PatternRequest&) { return without_tilt(Leopard()); }
PatternPtr pattern::make_radial(const PatternRequest&) { return without_tilt(Radial()); }

PatternPtr pattern::make_quilted(const PatternRequest& request) {
  const auto& controls = request.get<QuiltedParameters>();
  return make_lane_field<CenterFormula>(Quilted{in_single(controls.control0), in_single(controls.control1)}, values_of,
                                        tilts_of);
}

PatternPtr pattern::make_gradient(const PatternRequest& request) {
  const Vec3& axis = request.get<GradientParameters>().axis;
  const double length = axis.length();
  return without_tilt(Gradient{length > 0.0 ? axis / length : axis});
}

}  // namespace firstlight::render
#endif
