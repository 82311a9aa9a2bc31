// Shapes made of distances, exponentials and angles.
// Source   The formulas as POV-Ray 3.7 evaluates them; the order of operations is its own, for rounding.
#include "render/function/internal.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/function/internal_solids.cpp"
#include <hwy/foreach_target.h>

#include "render/function/internal-inl.h"
#include "render/lanes/math-inl.h"
#include "render/lanes/math.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#ifndef FIRSTLIGHT_INTERNAL_SOLIDS
#define FIRSTLIGHT_INTERNAL_SOLIDS(ROW) \
  ROW(6, blob, 8)                       \
  ROW(7, blob2, 7)                      \
  ROW(9, comma, 4)                      \
  ROW(10, cross_ellipsoids, 7)          \
  ROW(17, ellipsoid, 6)                 \
  ROW(19, flange_cover, 7)              \
  ROW(24, helical_torus, 13)            \
  ROW(25, helix1, 10)                   \
  ROW(26, helix2, 10)                   \
  ROW(27, hex_x, 4)                     \
  ROW(28, hex_y, 4)                     \
  ROW(32, isect_ellipsoids, 7)          \
  ROW(40, mesh1, 8)                     \
  ROW(47, ph, 3)                        \
  ROW(51, poly4, 8)                     \
  ROW(52, polytubes, 9)                 \
  ROW(53, quantum, 4)                   \
  ROW(57, r, 3)                         \
  ROW(60, rounded_box, 7)               \
  ROW(61, sphere, 4)                    \
  ROW(62, spikes, 8)                    \
  ROW(63, spikes_2d, 7)                 \
  ROW(64, spiral, 9)                    \
  ROW(68, superellipsoid, 5)            \
  ROW(69, th, 3)                        \
  ROW(70, torus, 5)

namespace firstlight::render {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTurn = 2.0 * kPi;

double radians(double degrees) { return degrees * (kPi / 180.0); }

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE L length_of(const L& a, const L& b, const L& c) {
  return sqrt(a * a + b * b + c * c);
}
template <class L>
HWY_INLINE L square(const L& a) {
  return a * a;
}
// A remainder that is never negative.
template <class L>
HWY_INLINE L wrap(const L& value, double period) {
  const L rest = remainder(value, period);
  return select(rest < 0.0, rest + period, rest);
}
/// x; on the y axis, where a point would have no angle, a number in place of 0.
template <class L>
HWY_INLINE L beside_axis(const Vec3Of<L>& p, double instead = 0.000001) {
  return select((p.x == 0.0) & (p.z == 0.0), L(instead), p.x);
}

// Parameters: distance of the parts, then of each its strength and inverse radius.
template <class L>
HWY_INLINE L blob_part(const L& x, const L& y2, const L& z2, double strength, double inverse) {
  const L rest = 1.0 - min((x * x + y2 + z2) * inverse * inverse, L(1.0));
  return strength * rest * rest;
}
template <class L>
HWY_INLINE L blob(const Vec3Of<L>& p, const double* own, int) {
  const L y2 = p.y * p.y, z2 = p.z * p.z;
  const double half = own[0] * 0.5;
  return -(blob_part<L>(p.x + half, y2, z2, own[1], own[2]) + blob_part<L>(p.x - half, y2, z2, own[3], own[4]));
}

// Parameters: distance, inverse size, strength, threshold.
template <class L>
HWY_INLINE L blob2(const Vec3Of<L>& p, const double* own, int) {
  const L x2 = p.x * p.x, y2 = p.y * p.y, z2 = p.z * p.z;
  const L sum = exponential(-(x2 + y2 + z2) * own[1]) + exponential(-(square(p.x - own[0]) + y2 + z2) * own[1]);
  return own[3] - sum * own[2];
}

template <class L>
HWY_INLINE L comma(const Vec3Of<L>& p, const double* own, int) {
  const double size = own[0];
  const L x = beside_axis(p, 0.0001), y = p.y, z = p.z;
  const L angle = arc_tangent(z, x);
  const L around = length_of<L>(x + size * 0.25, z);
  const L tail = cosine(angle * 0.5) * size * 0.5 - length_of<L>(around - size * 0.75, y);
  const L head = size * 0.5 - sqrt(square(x - size * 0.5) + z * z + y * y);
  return -max(min(z, tail), head);
}

/// Three ellipsoids, each long or short along an axis, as bells. Parameters: eccentricity, inverse size.
template <class L>
struct Ellipsoids {
  L along_z, along_y, along_x;
};
template <class L>
HWY_INLINE Ellipsoids<L> ellipsoids(const Vec3Of<L>& p, const double* own) {
  const L x2 = p.x * p.x, y2 = p.y * p.y, z2 = p.z * p.z;
  const double e = own[0], inverse = own[1];
  return {exponential(-(x2 * e + y2 * e + z2) * inverse), exponential(-(x2 * e + y2 + z2 * e) * inverse),
          exponential(-(x2 + y2 * e + z2 * e) * inverse)};
}

// Further parameters of these three: strength, threshold.
template <class L>
HWY_INLINE L cross_ellipsoids(const Vec3Of<L>& p, const double* own, int) {
  const Ellipsoids<L> e = ellipsoids(p, own);
  return own[3] - max(max(e.along_z, e.along_y), e.along_x) * own[2];
}
template <class L>
HWY_INLINE L isect_ellipsoids(const Vec3Of<L>& p, const double* own, int) {
  const Ellipsoids<L> e = ellipsoids(p, own);
  return own[3] - min(min(e.along_z, e.along_y), e.along_x) * own[2];
}
template <class L>
HWY_INLINE L flange_cover(const Vec3Of<L>& p, const double* own, int) {
  const Ellipsoids<L> e = ellipsoids(p, own);
  return own[3] - (e.along_z + e.along_y + e.along_x) * own[2];
}

// Parameters: eccentricity, inverse size, strength; of the ball in the middle its inverse size and strength.
template <class L>
HWY_INLINE L spikes(const Vec3Of<L>& p, const double* own, int) {
  const Ellipsoids<L> e = ellipsoids(p, own);
  const L ball = exponential(-(p.x * p.x + p.y * p.y + p.z * p.z) * own[3]) * own[4];
  return -(ball - e.along_z - e.along_y - e.along_x) * own[2];
}

template <class L>
HWY_INLINE L spikes_2d(const Vec3Of<L>& p, const double* own, int) {
  return -(own[0] * cosine(own[1] * p.x) * cosine(own[2] * p.z) * exponential(-own[3] * (p.x * p.x + p.z * p.z)) - p.y);
}

template <class L>
HWY_INLINE L ellipsoid(const Vec3Of<L>& p, const double* own, int) {
  return sqrt(p.x * p.x * own[0] * own[0] + p.y * p.y * own[1] * own[1] + p.z * p.z * own[2] * own[2]);
}

// Parameters: major radius, windings, twist, fatness, threshold, negative minor radius, further fatness, and period,
// amplitude and phase of the grooves.
template <class L>
HWY_INLINE L helical_torus(const Vec3Of<L>& p, const double* own, int) {
  const L around = length_of(p.x, p.z);
  const L angle = arc_tangent(beside_axis(p), p.z);
  const L from_ring = length_of<L>(around - own[0], p.y);
  const L winding = wrap<L>(angle * own[1] + arc_tangent<L>(around - own[0], p.y) * own[2], kTurn) - kPi;
  const L groove_angle = arc_tangent<L>(winding * own[8], from_ring - own[5]);
  const L groove = cosine(groove_angle * own[7] + angle * own[9]) * own[3] + own[4];
  const L tube = groove - min(sqrt(square(from_ring - own[5]) + winding * winding * own[6]), from_ring + own[5]);
  return -max(own[4] + own[5] - own[0] - around, tube);
}

// The distance from the middle of a tube's cross section: 1 a circle, 0 a square, between and beyond them rounded.
template <class L>
HWY_INLINE L cross_section(const L& x, const L& z, double kind) {
  if (kind == 1) return length_of(x, z);
  if (kind == 0) return max(abs(x), abs(z));
  const L exponent = 2.0 / kind;
  return power<L>(power(abs(x), exponent) + power(abs(z), exponent), L(kind * 0.5));
}

// Parameters: number of tubes, period, minor and major radius, shape, cross section and its angle.
template <class L>
HWY_INLINE L helix1(const Vec3Of<L>& p, const double* own, int) {
  const L around = length_of(p.x, p.z);
  const L angle = wrap<L>(arc_tangent(p.z, beside_axis(p)) * own[0] + p.y * own[1] * own[0], kTurn);
  L z = (angle - kPi) / own[4] / (own[1] * own[0]);
  L x = around - own[3];
  if (own[5] != 1 && own[6] != 0) {
    const double cosine = steady::cosine(radians(own[6])), sine = steady::sine(radians(own[6]));
    const L turned = x * cosine - z * sine;
    z = x * sine + z * cosine;
    x = turned;
  }
  return -own[2] + min(own[3] + around, cross_section(x, z, own[5]));
}

template <class L>
HWY_INLINE L helix2(const Vec3Of<L>& p, const double* own, int) {
  const L cos = cosine(p.y * own[1]), sin = sine(p.y * own[1]);
  const L x = p.x - own[3] * cos, z = p.z - own[3] * sin;
  return cross_section<L>(x * cos + z * sin, -x * sin + z * cos, own[5]) - own[2];
}

/// A point of the plane in its cell of a pattern of hexagons.
template <class L>
struct Hexagon {
  L x, y;
  MaskOf<L> near_x;  ///< within 30 degrees of the x axis
};
template <class L>
HWY_INLINE Hexagon<L> hexagon(const Vec3Of<L>& p) {
  const double width = std::sqrt(3.0);
  const L x = abs(remainder(abs(p.x), width) - width / 2);
  const L y = abs(remainder(abs(p.y), 3) - 1.5);
  const L other_x = width / 2 - x, other_y = 1.5 - y;
  const auto other = x * x + y * y > other_x * other_x + other_y * other_y;
  const L near_x = select(other, other_x, x), near_y = select(other, other_y, y);
  return {near_x, near_y, arc_tangent(near_y, near_x) < kPi / 6};
}

template <class L>
HWY_INLINE L hex_x(const Vec3Of<L>& p, const double*, int) {
  const Hexagon<L> h = hexagon(p);
  return select(h.near_x, h.x, steady::cosine(kPi / 3) * h.x + steady::sine(kPi / 3) * h.y);
}

template <class L>
HWY_INLINE L hex_y(const Vec3Of<L>& p, const double*, int) {
  const Hexagon<L> h = hexagon(p);
  return select(h.near_x, h.y, abs(-steady::sine(kPi / 3) * h.x + steady::cosine(kPi / 3) * h.y));
}

// Woven threads. Parameters: distances along x and z, thickness, amplitude, thickness along y.
template <class L>
HWY_INLINE L thread(const L& across, const L& y, const double* own, double distance, const L& wave) {
  const L aside = abs(wrap(across, distance * 2) - distance) * own[2];
  return -length_of<L>((y + wave) * own[4], aside);
}
template <class L>
HWY_INLINE L mesh1(const Vec3Of<L>& p, const double* own, int) {
  const L wave_z = cosine(p.z * (kPi / own[1])) * own[3], wave_x = cosine(p.x * (kPi / own[0])) * own[3];
  L nearest = thread<L>(p.x, p.y, own, own[0], -wave_z);
  nearest = max(thread<L>(p.x - own[0], p.y, own, own[0], wave_z), nearest);
  nearest = max(thread<L>(p.z, p.y, own, own[1], wave_x), nearest);
  return -max(thread<L>(p.z - own[1], p.y, own, own[1], -wave_x), nearest);
}

template <class L>
HWY_INLINE L ph(const Vec3Of<L>& p, const double*, int) {
  return arc_tangent(length_of(p.x, p.z), p.y);
}
template <class L>
HWY_INLINE L th(const Vec3Of<L>& p, const double*, int) {
  return arc_tangent(p.x, p.z);
}
template <class L>
HWY_INLINE L r(const Vec3Of<L>& p, const double*, int) {
  return length_of(p.x, p.y, p.z);
}

// A radius that is a polynomial of y.
template <class L>
HWY_INLINE L poly4(const Vec3Of<L>& p, const double* own, int) {
  const L y2 = p.y * p.y;
  const L radius = own[0] + own[1] * p.y + own[2] * y2 + own[3] * y2 * p.y + own[4] * y2 * y2;
  return -select(radius < -5.0, L(-5.0), radius) + length_of(p.x, p.z);
}

// Parameters: number of tubes about the y axis, and the polynomial of y that is their distance from it.
template <class L>
HWY_INLINE L polytubes(const Vec3Of<L>& p, const double* own, int) {
  constexpr double kMostTubes = 100000.0;
  const L y2 = p.y * p.y;
  const L away = own[1] + own[2] * p.y + own[3] * y2 + own[4] * y2 * p.y + own[5] * y2 * y2;
  L nearest = -10000.0;
  const int tubes = own[0] > 0.0 ? static_cast<int>(std::min(own[0], kMostTubes)) : 0;
  for (int i = 0; i < tubes; ++i) {
    const L x = p.x - away * steady::sine(2 * kPi / own[0] * i), z = p.z - away * steady::cosine(2 * kPi / own[0] * i);
    nearest = max(nearest, -length_of(x, z));
  }
  return -nearest;
}

template <class L>
HWY_INLINE L quantum(const Vec3Of<L>& p, const double*, int) {
  const L around = length_of(beside_axis(p, 1e-6), p.z);
  const L cos = cosine(arc_tangent(around, p.y));
  const L distance = length_of(around, p.y) * 2.0;
  const L wave = distance * distance * exponential(-distance * 0.33333333) * (3.0 * cos * cos - 1);
  return (wave * wave - 12.0) * (-0.1);
}

// Parameters: radius of the edges, half of the sides.
template <class L>
HWY_INLINE L beyond_side(const L& x, double half) {
  const L above = select(x < half, L(0.0), x - half);
  return max(select(x > -half, L(0.0), -half - x), above);
}
template <class L>
HWY_INLINE L rounded_box(const Vec3Of<L>& p, const double* own, int) {
  const L x = beyond_side(p.x, own[1] - own[0]), y = beyond_side(p.y, own[2] - own[0]),
          z = beyond_side(p.z, own[3] - own[0]);
  return -own[0] + length_of(x, y, z) - 1e-6;
}

template <class L>
HWY_INLINE L sphere(const Vec3Of<L>& p, const double* own, int) {
  return -own[0] + length_of(p.x, p.y, p.z);
}

// Parameters: distance of the turns, thickness, outer diameter, two without effect, cross section.
template <class L>
HWY_INLINE L spiral(const Vec3Of<L>& p, const double* own, int) {
  const L x = beside_axis(p);
  const L along = length_of(p.x, p.z) + own[0] * arc_tangent(p.z, x) / kTurn;
  const L across = remainder(along, own[0]) - own[0] * 0.5;
  L tube;
  if (own[5] == 1) {
    tube = length_of(across, p.y);
  } else if (own[5] != 0) {
    const double exponent = 2 / own[5];
    tube = power<L>(power<L>(abs(across), L(exponent)) + power<L>(abs(p.y), L(exponent)), L(1.0 / exponent));
  } else {
    tube = max(abs(across), abs(p.y));
  }
  const L distance = length_of(x, p.y, p.z);
  return -min(own[2] - distance, own[1] - min(tube, distance));
}

template <class L>
HWY_INLINE L superellipsoid(const Vec3Of<L>& p, const double* own, int) {
  const double east = own[0], north = own[1], inverse = 1 / north;
  const L exponent = 2 / east;
  const L round = power<L>(power(abs(p.x), exponent) + power(abs(p.y), exponent), L(east * inverse));
  return 1 - power<L>(round + power<L>(abs(p.z), L(2 * inverse)), L(north * 0.5));
}

template <class L>
HWY_INLINE L torus(const Vec3Of<L>& p, const double* own, int) {
  return -own[1] + length_of<L>(length_of(p.x, p.z) - own[0], p.y);
}

FIRSTLIGHT_INTERNAL_KERNEL(internal_solids, FIRSTLIGHT_INTERNAL_SOLIDS)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

FIRSTLIGHT_INTERNAL_MEMBERS(internal_solids, FIRSTLIGHT_INTERNAL_SOLIDS)

}  // namespace firstlight::render
#endif
