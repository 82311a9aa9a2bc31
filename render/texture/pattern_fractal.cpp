// Mandelbrot's and Julia's sets, and the two of a model of magnets.

#include "render/math/interrupt.h"
#include "render/texture/field.h"
#include "render/texture/patterns.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

/// Where a point has got to: z, how near to the origin it came, and after how many rounds it left, if it did.
struct Orbit {
  double a = 0.0, b = 0.0;
  double nearest = 0.0;  ///< squared
  int rounds = 0;
  bool left = false;
};

/// A scene may ask for two thousand million rounds: whether to leave with the orbit as it is.
bool is_interrupted(int rounds) {
  constexpr int kRoundsBetween = 1 << 12;
  return rounds % kRoundsBetween == kRoundsBetween - 1 && Interrupt::asked();
}

double exterior_value(const FractalParameters& fractal, const Orbit& orbit) {
  const double factor = fractal.exterior_factor;
  switch (fractal.exterior_type) {
    case 0:
      return factor;
    case 1:
      return static_cast<double>(orbit.rounds) / fractal.iterations;
    case 2:
      return orbit.a * factor;
    case 3:
      return orbit.b * factor;
    case 4:
      return orbit.a * orbit.a * factor;
    case 5:
      return orbit.b * orbit.b * factor;
    case 6:
      return std::sqrt(orbit.a * orbit.a + orbit.b * orbit.b) * factor;
    default: {
      // As whole numbers in POV-Ray; one below zero is larger than any number of rounds there.
      const double count = std::trunc(fractal.exterior_type == 7 ? factor : 1.0 + factor);
      if (count == 0.0) return 0.0;
      return (count > 0.0 ? std::fmod(orbit.rounds, count) : orbit.rounds) / factor;
    }
  }
}

double interior_value(const FractalParameters& fractal, const Orbit& orbit) {
  const double factor = fractal.interior_factor;
  switch (fractal.interior_type) {
    case 1:
      return std::sqrt(orbit.nearest) * factor;
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

struct Complex {
  double a = 0.0, b = 0.0;
};

// z^n with the sums in POV-Ray's order for the exponents that it has formulas of their own for; the binomial formula for
// the rest. The squares of z's parts are given, for the distance asks for them too.
struct Square {
  Complex operator()(double a, double b, double a2, double b2) const { return {a2 - b2, 2.0 * a * b}; }
};
struct Cube {
  Complex operator()(double a, double b, double a2, double b2) const {
    return {a2 * a - 3.0 * a * b2, 3.0 * a2 * b - b2 * b};
  }
};
struct Fourth {
  Complex operator()(double a, double b, double a2, double b2) const {
    return {a2 * a2 - 6.0 * a2 * b2 + b2 * b2, 4.0 * (a2 * a * b - a * b2 * b)};
  }
};
struct AnyPower {
  int exponent;
  Complex operator()(double a, double b, double a2, double b2) const;
};

Complex AnyPower::operator()(double a, double b, double /*a2*/, double /*b2*/) const {
  Complex sum;
  double coefficient = 1.0;  // of a^(n-k) b^k, without its sign
  for (int k = 0; k <= exponent; ++k) {
    const double term = coefficient * std::pow(a, exponent - k) * std::pow(b, k);
    double& part = k % 2 == 0 ? sum.a : sum.b;
    part += k % 4 < 2 ? term : -term;
    coefficient = coefficient * (exponent - k) / (k + 1);
  }
  return sum;
}

/// Rounds of z -> z^n + c, left beyond a distance of 2.
template <class Power>
Orbit power_orbit(int most_rounds, const Complex& z, const Complex& c, const Power& power) {
  constexpr double kFar = 4.0;
  double a = z.a, b = z.b, a2 = a * a, b2 = b * b;
  double nearest = a2 + b2;
  bool left = false;
  int rounds = 0;
  for (; rounds < most_rounds; ++rounds) {
    const Complex next = power(a, b, a2, b2);
    a = next.a + c.a;
    b = next.b + c.b;
    a2 = a * a;
    b2 = b * b;
    const double distance = a2 + b2;
    nearest = std::min(nearest, distance);
    left = distance > kFar;
    if (left || is_interrupted(rounds)) break;
  }
  return {a, b, nearest, rounds, left};
}

Orbit power_orbit(const FractalParameters& fractal, const Complex& z, const Complex& c) {
  switch (fractal.exponent) {
    case 2:
      return power_orbit(fractal.iterations, z, c, Square());
    case 3:
      return power_orbit(fractal.iterations, z, c, Cube());
    case 4:
      return power_orbit(fractal.iterations, z, c, Fourth());
    default:
      return power_orbit(fractal.iterations, z, c, AnyPower{fractal.exponent});
  }
}

/// ((z^2 + c - 1) / (2 z + c - 2))^2, before the square.
void magnet1(const Complex& z, const Complex& c, Complex& upper, Complex& lower) {
  upper = {z.a * z.a - z.b * z.b + c.a - 1.0, 2.0 * z.a * z.b + c.b};
  lower = {2.0 * z.a + c.a - 2.0, 2.0 * z.b + c.b};
}

/// ((z^3 + 3 (c-1) z + (c-1)(c-2)) / (3 z^2 + 3 (c-2) z + (c-1)(c-2) + 1))^2, before the square.
void magnet2(const Complex& z, const Complex& c, Complex& upper, Complex& lower) {
  const double c1 = c.a - 1.0, c2 = c.a - 2.0;
  const double a = z.a, b = z.b, a2 = a * a, b2 = b * b;
  const Complex product = {c1 * c2 - c.b * c.b, (c1 + c2) * c.b};
  upper = {a2 * a - 3.0 * a * b2 + 3.0 * (a * c1 - b * c.b) + product.a,
           3.0 * a2 * b - b2 * b + 3.0 * (a * c.b + b * c1) + product.b};
  lower = {3.0 * (a2 - b2) + 3.0 * (a * c2 - b * c.b) + product.a + 1.0,
           6.0 * a * b + 3.0 * (a * c.b + b * c2) + product.b};
}

Orbit magnet_orbit(const FractalParameters& fractal, Complex z, const Complex& c) {
  constexpr double kFar = 10000.0;
  constexpr double kAtOne = 1.0 / 10000.0;  // 1 is where orbits may end too
  Orbit orbit;
  orbit.nearest = fractal.julia ? z.a * z.a + z.b * z.b : kFar;
  for (; orbit.rounds < fractal.iterations; ++orbit.rounds) {
    Complex upper, lower;
    fractal.magnet == 1 ? magnet1(z, c, upper, lower) : magnet2(z, c, upper, lower);
    const double size = lower.a * lower.a + lower.b * lower.b;
    const double a = (upper.a * lower.a + upper.b * lower.b) / size;
    const double b = (upper.b * lower.a - upper.a * lower.b) / size;
    z = {a * a - b * b, 2.0 * a * b};
    const double distance = z.a * z.a + z.b * z.b;
    orbit.nearest = std::min(orbit.nearest, distance);
    orbit.left = distance > kFar || (z.a - 1.0) * (z.a - 1.0) + z.b * z.b < kAtOne;
    if (orbit.left || is_interrupted(orbit.rounds)) break;
  }
  orbit.a = z.a;
  orbit.b = z.b;
  return orbit;
}

double fractal_value(const FractalParameters& fractal, const Vec3& point) {
  const Complex here = {point.x, point.y};
  const Complex start = {fractal.start.x, fractal.start.y};
  Orbit orbit;
  if (fractal.magnet != 0) {
    orbit = magnet_orbit(fractal, fractal.julia ? here : Complex(), fractal.julia ? start : here);
  } else {
    orbit = power_orbit(fractal, here, fractal.julia ? start : here);
  }
  return orbit.left ? exterior_value(fractal, orbit) : interior_value(fractal, orbit);
}

}  // namespace

PatternPtr pattern::make_fractal(const PatternRequest& request) {
  return make_field([parameters = request.get<FractalParameters>()](const Vec3& point) { return fractal_value(parameters, point); });
}

}  // namespace firstlight::render
