// Algebraic surfaces: the zeros of a polynomial of x, y and z, times a strength (the first parameter) and held within
// -10 and 10, so that a search for the surface is not led astray by its steep far parts.
// Source   The polynomials as POV-Ray 3.7 evaluates them; the order of operations is its own, for rounding.
#include "render/function/internal.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/function/internal_surfaces.cpp"
#include <hwy/foreach_target.h>

#include "render/function/internal-inl.h"

#include <numbers>

#ifndef FIRSTLIGHT_INTERNAL_SURFACES
#define FIRSTLIGHT_INTERNAL_SURFACES(ROW) \
  ROW(4, bicorn, 5)                       \
  ROW(5, bifolia, 5)                      \
  ROW(8, boy_surface, 5)                  \
  ROW(11, crossed_trough, 4)              \
  ROW(12, cubic_saddle, 4)                \
  ROW(13, cushion, 4)                     \
  ROW(14, devils_curve, 4)                \
  ROW(16, dupin_cyclid, 9)                \
  ROW(18, enneper, 4)                     \
  ROW(20, folium_surface, 6)              \
  ROW(22, glob, 4)                        \
  ROW(23, heart, 4)                       \
  ROW(30, hunt_surface, 4)                \
  ROW(31, hyperbolic_torus, 6)            \
  ROW(33, kampyle_of_eudoxus, 6)          \
  ROW(35, klein_bottle, 4)                \
  ROW(36, kummer_surface_v1, 4)           \
  ROW(37, kummer_surface_v2, 7)           \
  ROW(38, lemniscate_of_gerono, 4)        \
  ROW(41, mitre, 4)                       \
  ROW(42, nodal_cubic, 4)                 \
  ROW(43, cushion, 4)                     \
  ROW(44, ovals_of_cassini, 7)            \
  ROW(45, paraboloid, 4)                  \
  ROW(46, parabolic_torus, 6)             \
  ROW(48, pillow, 4)                      \
  ROW(49, piriform, 4)                    \
  ROW(54, quartic_paraboloid, 4)          \
  ROW(55, quartic_saddle, 4)              \
  ROW(56, quartic_cylinder, 6)            \
  ROW(65, steiners_roman, 4)              \
  ROW(66, strophoid, 7)                   \
  ROW(71, torus2, 6)                      \
  ROW(72, torus_gumdrop, 4)               \
  ROW(73, umbrella, 4)                    \
  ROW(74, witch_of_agnesi, 5)
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// A point, and the squares of its coordinates.
template <class L>
struct Powers {
  L x, y, z, x2, y2, z2;
};
template <class L>
HWY_INLINE Powers<L> powers_of(const Vec3Of<L>& p) {
  return {p.x, p.y, p.z, p.x * p.x, p.y * p.y, p.z * p.z};
}
template <class L>
HWY_INLINE L held(const double* own, const L& value) {
  return min(L(10.0), max(own[0] * value, L(-10.0)));
}

template <class L>
HWY_INLINE L bicorn(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const double size = own[1] * own[1];
  const L inner = p.x2 + p.z2 + 2 * own[1] * p.y - size;
  return held<L>(own, p.y2 * (size - (p.x2 + p.z2)) - inner * inner);
}

template <class L>
HWY_INLINE L bifolia(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const L sum = p.x2 + p.y * p.y + p.z2;
  return held<L>(own, -(sum * sum - own[1] * (p.x2 + p.z2) * p.y));
}

template <class L>
HWY_INLINE L boy_surface(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const L a = 1 - p.z, b = p.x2 + p.y2;
  const L first = 64 * a * a * a * p.z2 * p.z - 48 * a * a * p.z2 * (3 * p.x2 + 3 * p.y2 + 2 * p.z2);
  const L second =
      12 * a * p.z *
      (27 * b * b - 24 * p.z2 * b + 36 * std::numbers::sqrt2 * p.y * p.z * (p.y2 - 3 * p.x2) + 4 * p.z2 * p.z2);
  const L third =
      (9 * p.x2 + 9 * p.y2 - 2 * p.z2) *
      (-81 * b * b - 72 * p.z2 * b + 108 * std::numbers::sqrt2 * p.x * p.z * (p.x2 - 3 * p.y2) + 4 * p.z2 * p.z2);
  return held<L>(own, own[1] * (first + second + third));
}

template <class L>
HWY_INLINE L crossed_trough(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, p.x2 * p.z * p.z - p.y);
}

template <class L>
HWY_INLINE L cubic_saddle(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(p.x2 * p.x - p.y2 * p.y - p.z));
}

// Also `odd`, whose terms are the same in another order of factors.
template <class L>
HWY_INLINE L cushion(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const L edge = p.x2 - p.z;
  return held<L>(own, p.z2 * p.x2 - p.z2 * p.z2 - 2 * p.z * p.x2 + 2 * p.z2 * p.z + p.x2 - p.z2 - edge * edge -
                          p.y2 * p.y2 - 2 * p.x2 * p.y2 - p.y2 * p.z2 + 2 * p.y2 * p.z + p.y2);
}

template <class L>
HWY_INLINE L devils_curve(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(p.x2 * p.x2 + 2 * p.x2 * p.z2 - 0.36 * p.x2 - p.y2 * p.y2 + 0.25 * p.y2 + p.z2 * p.z2));
}

// Parameters: strength, the torus' radii, its displacement along x and y, radius of inversion.
template <class L>
HWY_INLINE L dupin_cyclid(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const double major = own[1], dx = own[3], dy = own[4];
  const double inversion = own[5] * own[5], minor2 = own[2] * own[2], dy2 = dy * dy;
  const double a = minor2 - dy2 - (dx + major) * (dx + major), b = minor2 - dy2 - (dx - major) * (dx - major);
  const double dx2 = dx * dx, major2 = major * major;
  return held<L>(
      own,
      -(a * b * (p.x2 * p.x2 + p.y2 * p.y2 + p.z2 * p.z2) + 2 * (a * b * (p.x2 * p.y2 + p.x2 * p.z2 + p.y2 * p.z2)) +
        2 * inversion *
            ((-dy2 - dx2 + minor2 + major2) * (2 * p.x * dx + 2 * p.y * dy - inversion) - 4 * dy * minor2 * p.y) *
            (p.x2 + p.y2 + p.z2) +
        4 * inversion * inversion * (dx * p.x + dy * p.y) * (-inversion + dy * p.y + dx * p.x) +
        4 * inversion * inversion * major2 * p.y2 + inversion * inversion * inversion * inversion));
}

// POV-Ray divides whole numbers in some coefficients, so that 2/3, 1/4 and 2/9 are 0 there.
template <class L>
HWY_INLINE L enneper(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const L z = select(abs(p.z) < 0.2, L(0.2), p.z);
  const L a = (p.y2 - p.x2) / (2 * z) + 2 * p.z2 / 9;
  const L b = (p.y2 - p.x2) / (4 * z);
  return held<L>(own, -(a * a * a - 6 * b * b));
}

template <class L>
HWY_INLINE L folium_surface(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, (p.y2 + p.z2) * (1 + (own[2] - 4 * own[1]) * p.x) + p.x2 * (1 + own[2]));
}

template <class L>
HWY_INLINE L glob(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, 0.5 * p.x2 * p.x2 * p.x + 0.5 * p.x2 * p.x2 - (p.y2 + p.z2));
}

template <class L>
HWY_INLINE L heart(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const L ball = 2 * p.x2 + p.y2 + p.z2 - 1;
  return held<L>(own, -(ball * ball * ball - 0.1 * p.x2 * p.z2 * p.z - p.y2 * p.z2 * p.z));
}

template <class L>
HWY_INLINE L hunt_surface(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const L ball = p.x2 + p.y2 + p.z2 - 13, cone = 3 * p.x2 + p.y2 - 4 * p.z2 - 12;
  return held<L>(own, -(4 * ball * ball * ball + 27 * cone * cone));
}

template <class L>
HWY_INLINE L hyperbolic_torus(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const double major2 = own[1] * own[1], minor2 = own[2] * own[2];
  const double sum = major2 + minor2, difference = major2 - minor2;
  return held<L>(own,
                 -(p.x2 * p.x2 + 2 * p.x2 * p.y2 - 2 * p.x2 * p.z2 - 2 * sum * p.x2 + p.y2 * p.y2 - 2 * p.y2 * p.z2 +
                   2 * difference * p.y2 + p.z2 * p.z2 + 2 * sum * p.z2 + difference * difference));
}

template <class L>
HWY_INLINE L kampyle_of_eudoxus(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const double closeness = own[2] * own[2];
  return held<L>(own, -((p.y2 + p.z2) - closeness * p.x2 * p.x2 + closeness * own[1] * own[1] * p.x2));
}

template <class L>
HWY_INLINE L klein_bottle(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const L inner = p.x2 + p.y2 + p.z2 - 2 * p.y - 1;
  return held<L>(own, -((p.x2 + p.y2 + p.z2 + 2 * p.y - 1) * (inner * inner - 8 * p.z2) + 16 * p.x * p.z * inner));
}

template <class L>
HWY_INLINE L kummer_surface_v1(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(p.x2 * p.x2 + p.y2 * p.y2 + p.z2 * p.z2 - p.x2 - p.y2 - p.z2 - p.x2 * p.y2 - p.x2 * p.z2 -
                        p.y2 * p.z2 + 1));
}

template <class L>
HWY_INLINE L kummer_surface_v2(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(p.x2 * p.x2 + p.y2 * p.y2 + p.z2 * p.z2 + own[1] * (p.x2 + p.y2 + p.z2) +
                        own[2] * (p.x2 * p.y2 + p.x2 * p.z2 + p.y2 * p.z2) + own[3] * p.x * p.y * p.z - 1));
}

template <class L>
HWY_INLINE L lemniscate_of_gerono(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(p.x2 * p.x2 - p.x2 + p.y2 + p.z2));
}

template <class L>
HWY_INLINE L mitre(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(4 * p.x2 * (p.x2 + p.y2 + p.z2) - p.y2 * (1 - p.y2 - p.z2)));
}

template <class L>
HWY_INLINE L nodal_cubic(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(p.y2 * p.y + p.z2 * p.z - 6 * p.y * p.z));
}

template <class L>
HWY_INLINE L ovals_of_cassini(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const L sum = p.x2 + p.y2 + p.z2 + own[1] * own[1];
  return held<L>(own, -(sum * sum - own[3] * own[1] * own[1] * (p.x2 + p.z2) - own[2] * own[2]));
}

template <class L>
HWY_INLINE L paraboloid(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(p.x2 - p.y + p.z2));
}

template <class L>
HWY_INLINE L parabolic_torus(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const double major2 = own[1] * own[1], minor2 = own[2] * own[2];
  const double sum = major2 + minor2, difference = major2 - minor2;
  return held<L>(own, -(p.x2 * p.x2 + 2 * p.x2 * p.y2 - 2 * p.x2 * p.z - sum * p.x2 + p.y2 * p.y2 - 2 * p.y2 * p.z +
                        difference * p.y2 + p.z2 + sum * p.z + difference * difference));
}

template <class L>
HWY_INLINE L pillow(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, p.x2 * p.x2 + p.y2 * p.y2 + p.z2 * p.z2 - (p.x2 + p.y2 + p.z2));
}

template <class L>
HWY_INLINE L piriform(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return -held<L>(own, -((p.x2 * p.x2 - p.x2 * p.x) + p.y2 + p.z2));
}

template <class L>
HWY_INLINE L quartic_paraboloid(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(p.x2 * p.x2 + p.z2 * p.z2 - p.y));
}

template <class L>
HWY_INLINE L quartic_saddle(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(p.x2 * p.x2 - p.z2 * p.z2 - p.y));
}

template <class L>
HWY_INLINE L quartic_cylinder(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const L ring = p.x2 + p.z2, width = own[2] * own[2];
  return held<L>(own, -(ring * p.y * p.y + width * ring - width * own[1] * own[1]));
}

template <class L>
HWY_INLINE L steiners_roman(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(p.x2 * p.y2 + p.x2 * p.z2 + p.y2 * p.z2 + p.x * p.y * p.z));
}

template <class L>
HWY_INLINE L strophoid(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const double size = own[3] * own[3];
  return held<L>(own, -((own[2] - p.x) * (p.y2 + p.z2) - size * own[1] * p.x2 - size * p.x2 * p.x));
}

template <class L>
HWY_INLINE L torus2(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const double major2 = own[1] * own[1], minor2 = own[2] * own[2];
  const double sum = major2 + minor2, difference = major2 - minor2;
  return held<L>(own, -(p.x2 * p.x2 + p.y2 * p.y2 + p.z2 * p.z2 + 2 * p.x2 * p.y2 + 2 * p.x2 * p.z2 + 2 * p.y2 * p.z2 -
                        2 * sum * p.x2 + 2 * difference * p.y2 - 2 * sum * p.z2 + difference * difference));
}

template <class L>
HWY_INLINE L torus_gumdrop(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  const L ring = p.y2 + p.z2;
  return held<L>(own, -(4 * (p.x2 * p.x2 + ring * ring) + 17 * p.x2 * ring - 20 * (p.x2 + p.y2 + p.z2) + 17));
}

template <class L>
HWY_INLINE L umbrella(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(p.x2 - p.y * p.z * p.z));
}

template <class L>
HWY_INLINE L witch_of_agnesi(const Vec3Of<L>& at, const double* own, int) {
  const Powers<L> p = powers_of(at);
  return held<L>(own, -(own[1] * (p.y - 1) + (p.x2 + p.z2) * p.y));
}

FIRSTLIGHT_INTERNAL_KERNEL(internal_surfaces, FIRSTLIGHT_INTERNAL_SURFACES)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

FIRSTLIGHT_INTERNAL_MEMBERS(internal_surfaces, FIRSTLIGHT_INTERNAL_SURFACES)

}  // namespace firstlight::render
#endif
