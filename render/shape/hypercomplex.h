#pragma once

#include "render/math/vec.h"
#include "render/shape/julia_fractal.h"

#include <complex>

namespace firstlight::render {

// Hypercomplex numbers x + i y + j z + k w with i^2 = j^2 = -1, k^2 = 1, ij = k, which commute. They are two complex
// numbers side by side, (x - w) + i (y + z) and (x + w) + i (y - z). [POV-Ray 3.7 manual, "Julia Fractal"]

inline Vec4 hyper_product(const Vec4& a, const Vec4& b) {
  return Vec4(a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w, a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
              a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w, a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w);
}

inline Vec4 hyper_square(const Vec4& a) {
  return Vec4(a.x * a.x - a.y * a.y - a.z * a.z + a.w * a.w, 2.0 * (a.x * a.y - a.z * a.w),
              2.0 * (a.z * a.x - a.w * a.y), 2.0 * (a.w * a.x + a.z * a.y));
}

/// 1 / a; `a` stays what it was where there is none. False then.
bool hyper_reciprocal(const Vec4& a, Vec4& result);

/// A function of complex numbers, of both that a hypercomplex one is made of.
using ComplexFunction = std::complex<double> (*)(const std::complex<double>& z, const std::complex<double>& exponent);

/// Source  The branches are POV-Ray's: its arc functions are written with its own root and logarithm. The arc cosine's values
///         and those of the arc sine are what its formulas give, which is not always the principal value.
/// Null: of the square, the cube and the reciprocal, which need none.
ComplexFunction complex_function(JuliaFunction function);

inline Vec4 hyper_function(const Vec4& a, ComplexFunction function, const std::complex<double>& exponent) {
  const std::complex<double> first = function({a.x - a.w, a.y + a.z}, exponent);
  const std::complex<double> second = function({a.x + a.w, a.y - a.z}, exponent);
  return Vec4(0.5 * (first.real() + second.real()), 0.5 * (first.imag() + second.imag()),
              0.5 * (first.imag() - second.imag()), 0.5 * (second.real() - first.real()));
}

}  // namespace firstlight::render
