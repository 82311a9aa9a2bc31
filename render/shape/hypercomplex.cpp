#include "render/shape/hypercomplex.h"

#include "render/lanes/math.h"

#include <cmath>

namespace firstlight::render {
namespace {

using Complex = std::complex<double>;

// std::complex's own product, quotient and functions treat the infinite apart; these are the plain formulas.

Complex product(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

Complex quotient(const Complex& a, const Complex& b) {
  const double square = b.real() * b.real() + b.imag() * b.imag();
  return square == 0.0 ? Complex() : product(a, {b.real() / square, -b.imag() / square});
}

Complex root(const Complex& z) {
  if (z.real() == 0.0 && z.imag() == 0.0) return {};
  const double size = std::sqrt(std::sqrt(z.real() * z.real() + z.imag() * z.imag()));
  const double angle = steady::arc_tangent(z.imag(), z.real()) / 2.0;
  return {size * steady::cosine(angle), size * steady::sine(angle)};
}

Complex logarithm(const Complex& z) {
  return {steady::logarithm(std::sqrt(z.real() * z.real() + z.imag() * z.imag())),
          steady::arc_tangent(z.imag(), z.real())};
}

Complex exponential(const Complex& z) {
  const double size = steady::exponential(z.real());
  return {size * steady::cosine(z.imag()), size * steady::sine(z.imag())};
}

Complex sine(const Complex& z) {
  return {steady::sine(z.real()) * steady::hyperbolic_cosine(z.imag()),
          steady::cosine(z.real()) * steady::hyperbolic_sine(z.imag())};
}

Complex hyperbolic_sine(const Complex& z) {
  return {steady::hyperbolic_sine(z.real()) * steady::cosine(z.imag()),
          steady::hyperbolic_cosine(z.real()) * steady::sine(z.imag())};
}

Complex cosine(const Complex& z) {
  return {steady::cosine(z.real()) * steady::hyperbolic_cosine(z.imag()),
          -steady::sine(z.real()) * steady::hyperbolic_sine(z.imag())};
}

Complex hyperbolic_cosine(const Complex& z) {
  return {steady::hyperbolic_cosine(z.real()) * steady::cosine(z.imag()),
          steady::hyperbolic_sine(z.real()) * steady::sine(z.imag())};
}

Complex tangent(const Complex& z) {
  const double below = steady::cosine(2.0 * z.real()) + steady::hyperbolic_cosine(2.0 * z.imag());
  if (below == 0.0) return {};
  return {steady::sine(2.0 * z.real()) / below, steady::hyperbolic_sine(2.0 * z.imag()) / below};
}

Complex hyperbolic_tangent(const Complex& z) {
  const double below = steady::hyperbolic_cosine(2.0 * z.real()) + steady::cosine(2.0 * z.imag());
  if (below == 0.0) return {};
  return {steady::hyperbolic_sine(2.0 * z.real()) / below, steady::sine(2.0 * z.imag()) / below};
}

/// ln(i z + sqrt(1 - z^2)) / i
Complex arc_sine(const Complex& z) {
  const Complex square = product(z, z);
  const Complex r = root({1.0 - square.real(), -square.imag()});
  const Complex l = logarithm({r.real() - z.imag(), r.imag() + z.real()});
  return {l.imag(), -l.real()};
}

/// ln(z + sqrt(z^2 - 1))
Complex hyperbolic_arc_cosine(const Complex& z) {
  const Complex square = product(z, z);
  return logarithm(z + root({square.real() - 1.0, square.imag()}));
}

/// The same over i.
Complex arc_cosine(const Complex& z) {
  const Complex l = hyperbolic_arc_cosine(z);
  return {l.imag(), -l.real()};
}

/// ln(z + sqrt(z^2 + 1))
Complex hyperbolic_arc_sine(const Complex& z) {
  const Complex square = product(z, z);
  return logarithm(z + root({square.real() + 1.0, square.imag()}));
}

/// ln((1 + z) / (1 - z)) / 2
Complex hyperbolic_arc_tangent(const Complex& z) {
  if (z.real() == 0.0) return {0.0, steady::arc_tangent(z.imag())};
  if (z.imag() == 0.0) {
    if (std::abs(z.real()) == 1.0) return {};
    if (std::abs(z.real()) < 1.0) return {steady::logarithm((1.0 + z.real()) / (1.0 - z.real())) / 2.0, 0.0};
  }
  return logarithm(quotient({1.0 + z.real(), z.imag()}, {1.0 - z.real(), -z.imag()})) * 0.5;
}

/// i ln((1 - i z) / (1 + i z)) / 2
Complex arc_tangent(const Complex& z) {
  if (z.imag() == 0.0) return {steady::arc_tangent(z.real()), 0.0};
  if (z.real() == 0.0) {
    const Complex turned = hyperbolic_arc_tangent({z.imag(), 0.0});
    return {-turned.imag(), turned.real()};
  }
  const Complex l = logarithm(quotient({1.0 + z.imag(), -z.real()}, {1.0 - z.imag(), z.real()}));
  return {-0.5 * l.imag(), 0.5 * l.real()};
}

Complex power(const Complex& z, const Complex& exponent) {
  if (z.real() == 0.0 && z.imag() == 0.0) return {};
  const Complex l = product(logarithm(z), exponent);
  constexpr double kLeast = -690.0;  // below, POV-Ray takes the exponential for 0
  const double size = l.real() < kLeast ? 0.0 : steady::exponential(l.real());
  return {size * steady::cosine(l.imag()), size * steady::sine(l.imag())};
}

/// A function that needs no exponent.
template <Complex (*F)(const Complex&)>
Complex plain(const Complex& z, const Complex&) {
  return F(z);
}

}  // namespace

bool hyper_reciprocal(const Vec4& a, Vec4& result) {
  const double below =
      ((a.x - a.w) * (a.x - a.w) + (a.y + a.z) * (a.y + a.z)) * ((a.x + a.w) * (a.x + a.w) + (a.y - a.z) * (a.y - a.z));
  if (below == 0.0) return false;
  const double square = a.x * a.x + a.y * a.y + a.z * a.z + a.w * a.w;
  const double mixed = a.x * a.w - a.y * a.z;
  result = Vec4((a.x * square - 2.0 * a.w * mixed) / below, (-a.y * square - 2.0 * a.z * mixed) / below,
                (-a.z * square - 2.0 * a.y * mixed) / below, (a.w * square - 2.0 * a.x * mixed) / below);
  return true;
}

ComplexFunction complex_function(JuliaFunction function) {
  switch (function) {
    case JuliaFunction::exponential:
      return plain<exponential>;
    case JuliaFunction::sine:
      return plain<sine>;
    case JuliaFunction::arc_sine:
      return plain<arc_sine>;
    case JuliaFunction::hyperbolic_sine:
      return plain<hyperbolic_sine>;
    case JuliaFunction::hyperbolic_arc_sine:
      return plain<hyperbolic_arc_sine>;
    case JuliaFunction::cosine:
      return plain<cosine>;
    case JuliaFunction::arc_cosine:
      return plain<arc_cosine>;
    case JuliaFunction::hyperbolic_cosine:
      return plain<hyperbolic_cosine>;
    case JuliaFunction::hyperbolic_arc_cosine:
      return plain<hyperbolic_arc_cosine>;
    case JuliaFunction::tangent:
      return plain<tangent>;
    case JuliaFunction::arc_tangent:
      return plain<arc_tangent>;
    case JuliaFunction::hyperbolic_tangent:
      return plain<hyperbolic_tangent>;
    case JuliaFunction::hyperbolic_arc_tangent:
      return plain<hyperbolic_arc_tangent>;
    case JuliaFunction::natural_logarithm:
      return plain<logarithm>;
    case JuliaFunction::power:
      return power;
    case JuliaFunction::square:
    case JuliaFunction::cube:
    case JuliaFunction::reciprocal:
      break;
  }
  return nullptr;
}

}  // namespace firstlight::render
