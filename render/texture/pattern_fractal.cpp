// Mandelbrot's and Julia's sets, and the two of a model of magnets.

#include "render/math/interrupt.h"
#include "render/texture/lane_field.h"
#include "render/texture/patterns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/texture/pattern_fractal.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/lanes-inl.h"

#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Where points have got to: z, how near to the origin it came, and after how many rounds they left, if they did.
template <class L>
struct Orbit {
  L a, b;
  L nearest;  ///< squared
  L rounds;
  MaskOf<L> left;
};

template <class L>
struct Complex {
  L a, b;
};

/// A scene may ask for two thousand million rounds: whether to leave with the orbits as they are.
inline bool is_interrupted(int round) {
  constexpr int kRoundsBetween = 1 << 12;
  return round % kRoundsBetween == kRoundsBetween - 1 && Interrupt::asked();
}

template <class L>
HWY_INLINE L exterior_value(const FractalParameters& fractal, const Orbit<L>& orbit) {
  const double factor = fractal.exterior_factor;
  switch (fractal.exterior_type) {
    case 0:
      return factor;
    case 1:
      return orbit.rounds / static_cast<double>(fractal.iterations);
    case 2:
      return orbit.a * factor;
    case 3:
      return orbit.b * factor;
    case 4:
      return orbit.a * orbit.a * factor;
    case 5:
      return orbit.b * orbit.b * factor;
    case 6:
      return sqrt(orbit.a * orbit.a + orbit.b * orbit.b) * factor;
    default: {
      // As whole numbers in POV-Ray; one below zero is larger than any number of rounds there.
      const double count = std::trunc(fractal.exterior_type == 7 ? factor : 1.0 + factor);
      if (count == 0.0) return 0.0;
      return (count > 0.0 ? orbit.rounds - trunc(orbit.rounds / count) * count : orbit.rounds) / factor;
    }
  }
}

template <class L>
HWY_INLINE L interior_value(const FractalParameters& fractal, const Orbit<L>& orbit) {
  const double factor = fractal.interior_factor;
  switch (fractal.interior_type) {
    case 1:
      return sqrt(orbit.nearest) * factor;
    case 2:
      return orbit.a * factor;
    case 3:
      return orbit.b * factor;
    case 4:
      return orbit.a * orbit.a * factor;
    case 5:
      return orbit.b * orbit.b * factor;
    case 6:
      return orbit.a * orbit.a + orbit.b * orbit.b * factor;  // so in POV-Ray 3.7
    default:
      return factor;
  }
}

// z^n with the sums in POV-Ray's order for the exponents that it has formulas of their own for; the binomial formula for
// the rest. The squares of z's parts are given, for the distance asks for them too.
struct SquareOf {};
template <class L>
HWY_INLINE Complex<L> raised(SquareOf, const L& a, const L& b, const L& a2, const L& b2) {
  return {a2 - b2, 2.0 * a * b};
}
struct CubeOf {};
template <class L>
HWY_INLINE Complex<L> raised(CubeOf, const L& a, const L& b, const L& a2, const L& b2) {
  return {a2 * a - 3.0 * a * b2, 3.0 * a2 * b - b2 * b};
}
struct FourthOf {};
template <class L>
HWY_INLINE Complex<L> raised(FourthOf, const L& a, const L& b, const L& a2, const L& b2) {
  return {a2 * a2 - 6.0 * a2 * b2 + b2 * b2, 4.0 * (a2 * a * b - a * b2 * b)};
}
/// A number of twice the precision: the sum of both, of which `low` is less than half a unit of the last place of `high`.
template <class L>
struct Twofold {
  L high, low;
};

/// The upper 26 bits of x (Veltkamp).
template <class L>
HWY_INLINE L upper_half(const L& x) {
  const L shifted = 134217729.0 * x;
  return shifted - (shifted - x);
}

/// x y, rounded to twice the precision (Dekker's product).
template <class L>
HWY_INLINE Twofold<L> times(const Twofold<L>& x, const L& y) {
  const L product = x.high * y;
  const L x1 = upper_half(x.high), y1 = upper_half(y);
  const L x2 = x.high - x1, y2 = y - y1;
  const L rest = ((x1 * y1 - product) + x1 * y2 + x2 * y1) + x2 * y2 + x.low * y;
  const L high = product + rest;
  return {high, rest - (high - product)};
}

struct AnyPowerOf {
  int exponent;
};
constexpr int kLargestExponent = 33;
/// Every power is rounded once, as pow() would: orbits that do not leave tell a last bit from another after a few rounds.
template <class L>
HWY_INLINE Complex<L> raised(AnyPowerOf power, const L& a, const L& b, const L& /*a2*/, const L& /*b2*/) {
  L powers_of_a[kLargestExponent + 1];
  powers_of_a[0] = L(1.0);
  Twofold<L> power_of_a = {a, L(0.0)};
  for (int k = 1; k < power.exponent; ++k) {
    powers_of_a[k] = power_of_a.high;
    power_of_a = times(power_of_a, a);
  }
  powers_of_a[power.exponent] = power_of_a.high;
  Complex<L> sum = {powers_of_a[power.exponent], L(0.0)};
  double coefficient = power.exponent;  // of a^(n-k) b^k, without its sign
  Twofold<L> power_of_b = {b, L(0.0)};
  for (int k = 1;; ++k) {
    const L term = coefficient * powers_of_a[power.exponent - k] * power_of_b.high;
    L& part = k % 2 == 0 ? sum.a : sum.b;
    part = k % 4 < 2 ? part + term : part - term;
    if (k == power.exponent) break;
    coefficient = coefficient * (power.exponent - k) / (k + 1);
    power_of_b = times(power_of_b, b);
  }
  return sum;
}

/// Rounds of z -> z^n + c, left beyond a distance of 2. Each lane keeps what it has when it leaves; several vectors side by
/// side, for each waits for itself.
template <std::size_t kTogether, class L, class Power>
HWY_INLINE void power_orbits(const FractalParameters& fractal, const Power& power, const Complex<L>* start,
                             const Complex<L>* added, const MaskOf<L>* wanted, Orbit<L>* orbits) {
  constexpr double kFar = 4.0;
  L a[kTogether], b[kTogether], a2[kTogether], b2[kTogether];
  MaskOf<L> live[kTogether];
  for (std::size_t v = 0; v < kTogether; ++v) {
    a[v] = start[v].a;
    b[v] = start[v].b;
    a2[v] = a[v] * a[v];
    b2[v] = b[v] * b[v];
    live[v] = wanted[v];
    orbits[v] = {a[v], b[v], a2[v] + b2[v], L(0.0), without(live[v], live[v])};
  }
  for (int round = 0; round < fractal.iterations; ++round) {
    bool any_live = false;
    for (std::size_t v = 0; v < kTogether; ++v) {
      const Complex<L> next = raised(power, a[v], b[v], a2[v], b2[v]);
      a[v] = next.a + added[v].a;
      b[v] = next.b + added[v].b;
      a2[v] = a[v] * a[v];
      b2[v] = b[v] * b[v];
      const L distance = a2[v] + b2[v];
      orbits[v].nearest = select(live[v], min(orbits[v].nearest, distance), orbits[v].nearest);
      orbits[v].a = select(live[v], a[v], orbits[v].a);
      orbits[v].b = select(live[v], b[v], orbits[v].b);
      const MaskOf<L> leaves = live[v] & (distance > kFar);
      orbits[v].left = orbits[v].left | leaves;
      live[v] = without(live[v], leaves);
      orbits[v].rounds = select(live[v], orbits[v].rounds + 1.0, orbits[v].rounds);
      any_live = any_live || any(live[v]);
    }
    if (!any_live || is_interrupted(round)) return;
  }
}

/// ((z^2 + c - 1) / (2 z + c - 2))^2, before the square.
template <class L>
HWY_INLINE void magnet1(const Complex<L>& z, const Complex<L>& c, Complex<L>& upper, Complex<L>& lower) {
  upper = {z.a * z.a - z.b * z.b + c.a - 1.0, 2.0 * z.a * z.b + c.b};
  lower = {2.0 * z.a + c.a - 2.0, 2.0 * z.b + c.b};
}

/// ((z^3 + 3 (c-1) z + (c-1)(c-2)) / (3 z^2 + 3 (c-2) z + (c-1)(c-2) + 1))^2, before the square.
template <class L>
HWY_INLINE void magnet2(const Complex<L>& z, const Complex<L>& c, Complex<L>& upper, Complex<L>& lower) {
  const L c1 = c.a - 1.0, c2 = c.a - 2.0;
  const L a = z.a, b = z.b, a2 = a * a, b2 = b * b;
  const Complex<L> product = {c1 * c2 - c.b * c.b, (c1 + c2) * c.b};
  upper = {a2 * a - 3.0 * a * b2 + 3.0 * (a * c1 - b * c.b) + product.a,
           3.0 * a2 * b - b2 * b + 3.0 * (a * c.b + b * c1) + product.b};
  lower = {3.0 * (a2 - b2) + 3.0 * (a * c2 - b * c.b) + product.a + 1.0,
           6.0 * a * b + 3.0 * (a * c.b + b * c2) + product.b};
}

template <class L>
HWY_INLINE void magnet_orbit(const FractalParameters& fractal, Complex<L> z, const Complex<L>& c,
                             const MaskOf<L>& wanted, Orbit<L>& orbit) {
  constexpr double kFar = 10000.0;
  constexpr double kAtOne = 1.0 / 10000.0;  // 1 is where orbits may end too
  MaskOf<L> live = wanted;
  orbit = {z.a, z.b, fractal.julia ? z.a * z.a + z.b * z.b : L(kFar), L(0.0), without(live, live)};
  for (int round = 0; round < fractal.iterations; ++round) {
    Complex<L> upper, lower;
    fractal.magnet == 1 ? magnet1(z, c, upper, lower) : magnet2(z, c, upper, lower);
    const L size = lower.a * lower.a + lower.b * lower.b;
    const L a = (upper.a * lower.a + upper.b * lower.b) / size;
    const L b = (upper.b * lower.a - upper.a * lower.b) / size;
    z = {a * a - b * b, 2.0 * a * b};
    const L distance = z.a * z.a + z.b * z.b;
    orbit.nearest = select(live, min(orbit.nearest, distance), orbit.nearest);
    orbit.a = select(live, z.a, orbit.a);
    orbit.b = select(live, z.b, orbit.b);
    const MaskOf<L> leaves = live & ((distance > kFar) | ((z.a - 1.0) * (z.a - 1.0) + z.b * z.b < kAtOne));
    orbit.left = orbit.left | leaves;
    live = without(live, leaves);
    orbit.rounds = select(live, orbit.rounds + 1.0, orbit.rounds);
    if (!any(live) || is_interrupted(round)) return;
  }
}

/// The orbits of kTogether vectors of points.
template <std::size_t kTogether, class L>
HWY_INLINE void orbits_of(const FractalParameters& fractal, const Complex<L>* points, const MaskOf<L>* wanted,
                          Orbit<L>* orbits) {
  const Complex<L> start = {L(fractal.start.x), L(fractal.start.y)};
  if (fractal.magnet != 0) {
    const Complex<L> zero = {L(0.0), L(0.0)};
    for (std::size_t v = 0; v < kTogether; ++v) {
      magnet_orbit(fractal, fractal.julia ? points[v] : zero, fractal.julia ? start : points[v], wanted[v], orbits[v]);
    }
    return;
  }
  Complex<L> added[kTogether];
  for (std::size_t v = 0; v < kTogether; ++v) added[v] = fractal.julia ? start : points[v];
  switch (fractal.exponent) {
    case 2:
      return power_orbits<kTogether>(fractal, SquareOf(), points, added, wanted, orbits);
    case 3:
      return power_orbits<kTogether>(fractal, CubeOf(), points, added, wanted, orbits);
    case 4:
      return power_orbits<kTogether>(fractal, FourthOf(), points, added, wanted, orbits);
    default:
      return power_orbits<kTogether>(fractal, AnyPowerOf{fractal.exponent}, points, added, wanted, orbits);
  }
}

void fractal_values(const FractalParameters& fractal, const Columns3<double>& at, std::size_t count,
                    Column<double>& values) {
  constexpr std::size_t kTogether = Lanes::kCount == kRaysAtOnce ? 1 : 2;
  for (std::size_t i = 0; i < count; i += kTogether * Lanes::kCount) {
    Complex<Lanes> points[kTogether];
    LanesMask wanted[kTogether];
    Orbit<Lanes> orbits[kTogether];
    for (std::size_t v = 0; v < kTogether; ++v) {
      const std::size_t first = i + v * Lanes::kCount;
      points[v] = {load<Lanes>(at.of[0], first), load<Lanes>(at.of[1], first)};
      wanted[v] = Lanes::first(first < count ? count - first : 0);
    }
    orbits_of<kTogether>(fractal, points, wanted, orbits);
    for (std::size_t v = 0; v < kTogether; ++v) {
      const Lanes value =
          select(orbits[v].left, exterior_value(fractal, orbits[v]), interior_value(fractal, orbits[v]));
      store(value, values, i + v * Lanes::kCount);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(fractal_values);

}  // namespace

PatternPtr pattern::make_fractal(const PatternRequest& request) {
  return make_lane_field(
      request.get<FractalParameters>(),
      [](const FractalParameters& fractal, const Columns3<double>& at, std::size_t count, Column<double>& values) {
        HWY_DYNAMIC_DISPATCH(fractal_values)(fractal, at, count, values);
      });
}

}  // namespace firstlight::render
#endif
