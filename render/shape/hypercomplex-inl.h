// Hypercomplex numbers and functions of them over a lane type. Included once for each instruction set, so the guard
// switches back and forth.
#if defined(FIRSTLIGHT_RENDER_SHAPE_HYPERCOMPLEX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_SHAPE_HYPERCOMPLEX_INL_H
#undef FIRSTLIGHT_RENDER_SHAPE_HYPERCOMPLEX_INL_H
#else
#define FIRSTLIGHT_RENDER_SHAPE_HYPERCOMPLEX_INL_H
#endif

#include "render/lanes/hyperbolic-inl.h"
#include "render/lanes/lanes-inl.h"
#include "render/shape/julia_fractal.h"

#include <complex>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
struct Vec4Of {
  L x, y, z, w;
};
template <class L>
HWY_INLINE Vec4Of<L> select(const MaskOf<L>& which, const Vec4Of<L>& a, const Vec4Of<L>& b) {
  return {select(which, a.x, b.x), select(which, a.y, b.y), select(which, a.z, b.z), select(which, a.w, b.w)};
}
template <class L>
HWY_INLINE Vec4Of<L> operator*(const Vec4Of<L>& a, const Same<L>& s) {
  return {a.x * s, a.y * s, a.z * s, a.w * s};
}

// Hypercomplex numbers x + i y + j z + k w with i^2 = j^2 = -1, k^2 = 1, ij = k, which commute. They are two complex
// numbers side by side, (x - w) + i (y + z) and (x + w) + i (y - z). [POV-Ray 3.7 manual, "Julia Fractal"]

template <class L>
HWY_INLINE Vec4Of<L> hyper_product(const Vec4Of<L>& a, const Vec4Of<L>& b) {
  return {a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w, a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
          a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w, a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w};
}

template <class L>
HWY_INLINE Vec4Of<L> hyper_square(const Vec4Of<L>& a) {
  return {a.x * a.x - a.y * a.y - a.z * a.z + a.w * a.w, 2.0 * (a.x * a.y - a.z * a.w), 2.0 * (a.z * a.x - a.w * a.y),
          2.0 * (a.w * a.x + a.z * a.y)};
}

/// 1 / a; `none` where there is none.
template <class L>
HWY_INLINE Vec4Of<L> hyper_reciprocal(const Vec4Of<L>& a, const Vec4Of<L>& none) {
  const L below =
      ((a.x - a.w) * (a.x - a.w) + (a.y + a.z) * (a.y + a.z)) * ((a.x + a.w) * (a.x + a.w) + (a.y - a.z) * (a.y - a.z));
  const L square = a.x * a.x + a.y * a.y + a.z * a.z + a.w * a.w;
  const L mixed = a.x * a.w - a.y * a.z;
  const Vec4Of<L> result{(a.x * square - 2.0 * a.w * mixed) / below, (-a.y * square - 2.0 * a.z * mixed) / below,
                         (-a.z * square - 2.0 * a.y * mixed) / below, (a.w * square - 2.0 * a.x * mixed) / below};
  return select(below == 0.0, none, result);
}

// ---- Complex numbers, by the plain formulas. The branches are POV-Ray's: its arc functions are written with its own
// root and logarithm. The arc cosine's values and those of the arc sine are what its formulas give, which is not always the
// principal value.

template <class L>
struct ComplexOf {
  L real, imag;
};
template <class L>
HWY_INLINE ComplexOf<L> select(const MaskOf<L>& which, const ComplexOf<L>& a, const ComplexOf<L>& b) {
  return {select(which, a.real, b.real), select(which, a.imag, b.imag)};
}
template <class L>
HWY_INLINE ComplexOf<L> complex_zero() {
  return {L(0.0), L(0.0)};
}
template <class L>
HWY_INLINE MaskOf<L> is_zero(const ComplexOf<L>& z) {
  return (z.real == 0.0) & (z.imag == 0.0);
}

template <class L>
HWY_INLINE ComplexOf<L> product(const ComplexOf<L>& a, const ComplexOf<L>& b) {
  return {a.real * b.real - a.imag * b.imag, a.real * b.imag + a.imag * b.real};
}
template <class L>
HWY_INLINE ComplexOf<L> quotient(const ComplexOf<L>& a, const ComplexOf<L>& b) {
  const L square = b.real * b.real + b.imag * b.imag;
  return select(square == 0.0, complex_zero<L>(), product(a, ComplexOf<L>{b.real / square, -b.imag / square}));
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> root(const ComplexOf<L>& z) {
  const L size = sqrt(sqrt(z.real * z.real + z.imag * z.imag));
  const L angle = arc_tangent(z.imag, z.real) / 2.0;
  return select(is_zero(z), complex_zero<L>(), ComplexOf<L>{size * cosine(angle), size * sine(angle)});
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_logarithm(const ComplexOf<L>& z) {
  return {logarithm(sqrt(z.real * z.real + z.imag * z.imag)), arc_tangent(z.imag, z.real)};
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_exponential(const ComplexOf<L>& z) {
  const L size = exponential(z.real);
  return {size * cosine(z.imag), size * sine(z.imag)};
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_sine(const ComplexOf<L>& z) {
  return {sine(z.real) * hyperbolic_cosine(z.imag), cosine(z.real) * hyperbolic_sine(z.imag)};
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_hyperbolic_sine(const ComplexOf<L>& z) {
  return {hyperbolic_sine(z.real) * cosine(z.imag), hyperbolic_cosine(z.real) * sine(z.imag)};
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_cosine(const ComplexOf<L>& z) {
  return {cosine(z.real) * hyperbolic_cosine(z.imag), -sine(z.real) * hyperbolic_sine(z.imag)};
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_hyperbolic_cosine(const ComplexOf<L>& z) {
  return {hyperbolic_cosine(z.real) * cosine(z.imag), hyperbolic_sine(z.real) * sine(z.imag)};
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_tangent(const ComplexOf<L>& z) {
  const L below = cosine(2.0 * z.real) + hyperbolic_cosine(2.0 * z.imag);
  return select(below == 0.0, complex_zero<L>(),
                ComplexOf<L>{sine(2.0 * z.real) / below, hyperbolic_sine(2.0 * z.imag) / below});
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_hyperbolic_tangent(const ComplexOf<L>& z) {
  const L below = hyperbolic_cosine(2.0 * z.real) + cosine(2.0 * z.imag);
  return select(below == 0.0, complex_zero<L>(),
                ComplexOf<L>{hyperbolic_sine(2.0 * z.real) / below, sine(2.0 * z.imag) / below});
}
/// ln(i z + sqrt(1 - z^2)) / i
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_arc_sine(const ComplexOf<L>& z) {
  const ComplexOf<L> square = product(z, z);
  const ComplexOf<L> r = root(ComplexOf<L>{1.0 - square.real, -square.imag});
  const ComplexOf<L> l = complex_logarithm(ComplexOf<L>{r.real - z.imag, r.imag + z.real});
  return {l.imag, -l.real};
}
/// ln(z + sqrt(z^2 + to))
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> arc_of(const ComplexOf<L>& z, double to) {
  const ComplexOf<L> square = product(z, z);
  const ComplexOf<L> r = root(ComplexOf<L>{square.real + to, square.imag});
  return complex_logarithm(ComplexOf<L>{z.real + r.real, z.imag + r.imag});
}
/// ln(z + sqrt(z^2 - 1)) / i
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_arc_cosine(const ComplexOf<L>& z) {
  const ComplexOf<L> l = arc_of(z, -1.0);
  return {l.imag, -l.real};
}
/// ln((1 + z) / (1 - z)) / 2
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_hyperbolic_arc_tangent(const ComplexOf<L>& z) {
  const L size = abs(z.real);
  const ComplexOf<L> l =
      complex_logarithm(quotient(ComplexOf<L>{1.0 + z.real, z.imag}, ComplexOf<L>{1.0 - z.real, -z.imag}));
  const ComplexOf<L> result{l.real * 0.5, l.imag * 0.5};
  const ComplexOf<L> flat{select(size == 1.0, L(0.0), logarithm((1.0 + z.real) / (1.0 - z.real)) / 2.0), L(0.0)};
  return select(z.real == 0.0, ComplexOf<L>{L(0.0), arc_tangent(z.imag)},
                select((z.imag == 0.0) & (size <= 1.0), flat, result));
}
/// i ln((1 - i z) / (1 + i z)) / 2
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_arc_tangent(const ComplexOf<L>& z) {
  const ComplexOf<L> turned = complex_hyperbolic_arc_tangent(ComplexOf<L>{z.imag, L(0.0)});
  const ComplexOf<L> l =
      complex_logarithm(quotient(ComplexOf<L>{1.0 + z.imag, -z.real}, ComplexOf<L>{1.0 - z.imag, z.real}));
  return select(
      z.imag == 0.0, ComplexOf<L>{arc_tangent(z.real), L(0.0)},
      select(z.real == 0.0, ComplexOf<L>{-turned.imag, turned.real}, ComplexOf<L>{-0.5 * l.imag, 0.5 * l.real}));
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION ComplexOf<L> complex_power(const ComplexOf<L>& z, const std::complex<double>& exponent) {
  const ComplexOf<L> l = product(complex_logarithm(z), ComplexOf<L>{L(exponent.real()), L(exponent.imag())});
  constexpr double kLeast = -690.0;  // below, POV-Ray takes the exponential for 0
  const L size = select(l.real < kLeast, L(0.0), exponential(l.real));
  return select(is_zero(z), complex_zero<L>(), ComplexOf<L>{size * cosine(l.imag), size * sine(l.imag)});
}

/// A function of complex numbers. The square, the cube and the reciprocal are iterated without: they give 0 here.
template <class L>
HWY_NOINLINE ComplexOf<L> complex_function(JuliaFunction function, const std::complex<double>& exponent,
                                           const ComplexOf<L>& z) {
  switch (function) {
    case JuliaFunction::exponential:
      return complex_exponential(z);
    case JuliaFunction::sine:
      return complex_sine(z);
    case JuliaFunction::arc_sine:
      return complex_arc_sine(z);
    case JuliaFunction::hyperbolic_sine:
      return complex_hyperbolic_sine(z);
    case JuliaFunction::hyperbolic_arc_sine:
      return arc_of(z, 1.0);
    case JuliaFunction::cosine:
      return complex_cosine(z);
    case JuliaFunction::arc_cosine:
      return complex_arc_cosine(z);
    case JuliaFunction::hyperbolic_cosine:
      return complex_hyperbolic_cosine(z);
    case JuliaFunction::hyperbolic_arc_cosine:
      return arc_of(z, -1.0);
    case JuliaFunction::tangent:
      return complex_tangent(z);
    case JuliaFunction::arc_tangent:
      return complex_arc_tangent(z);
    case JuliaFunction::hyperbolic_tangent:
      return complex_hyperbolic_tangent(z);
    case JuliaFunction::hyperbolic_arc_tangent:
      return complex_hyperbolic_arc_tangent(z);
    case JuliaFunction::natural_logarithm:
      return complex_logarithm(z);
    case JuliaFunction::power:
      return complex_power(z, exponent);
    case JuliaFunction::square:
    case JuliaFunction::cube:
    case JuliaFunction::reciprocal:
      break;
  }
  return complex_zero<L>();
}

template <class L>
FIRSTLIGHT_LANE_FUNCTION Vec4Of<L> hyper_function(JuliaFunction function, const std::complex<double>& exponent,
                                                  const Vec4Of<L>& a) {
  const auto first = complex_function(function, exponent, ComplexOf<L>{a.x - a.w, a.y + a.z});
  const auto second = complex_function(function, exponent, ComplexOf<L>{a.x + a.w, a.y - a.z});
  return {0.5 * (first.real + second.real), 0.5 * (first.imag + second.imag), 0.5 * (first.imag - second.imag),
          0.5 * (second.real - first.real)};
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
