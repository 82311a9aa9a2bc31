#pragma once

#include "render/math/vec.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace firstlight::render {

/// All points where a polynomial in x, y and z is 0; inside it is negative. `cubic`, `quartic`, `poly`, `polynomial`.
///
/// Order    Coefficients by falling powers of x, then of y, then of z: x^2, xy, xz, x, y^2, yz, y, z^2, z, 1.
/// Source   POV-Ray 3.7 manual, "Poly".
struct PolynomialForm {
  static constexpr int kLowestOrder = 2;
  static constexpr int kHighestOrder = 35;

  int order = 2;
  std::vector<double> coefficients;

  static std::size_t coefficient_count(int order) {
    const auto n = static_cast<std::size_t>(order);
    return (n + 1) * (n + 2) * (n + 3) / 6;
  }
  /// Place of the coefficient of x^i y^j z^k. Pre: none is negative and their sum is at most `order`.
  static std::size_t place(int order, int i, int j, int k) {
    const auto a = static_cast<std::size_t>(order - i);
    const std::size_t b = a - static_cast<std::size_t>(j);
    const std::size_t c = b - static_cast<std::size_t>(k);
    return a * (a + 1) * (a + 2) / 6 + b * (b + 1) / 2 + c;
  }
};

/// square . (x^2, y^2, z^2) + mixed . (xy, xz, yz) + linear . (x, y, z) + constant = 0.
struct QuadricForm {
  Vec3 square{1.0, 1.0, 1.0};
  Vec3 mixed{0.0, 0.0, 0.0};
  Vec3 linear{0.0, 0.0, 0.0};
  double constant = 1.0;
};

/// (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1, with e = `east_west` and n = `north_south`.
struct SuperellipsoidForm {
  double east_west = 1.0;
  double north_south = 1.0;
};

/// An egg around the y axis: a ball of `bottom_radius` at the origin, one of `top_radius` above it, and a part of a
/// torus that joins them smoothly. Neither radius is 0; top_radius < 2 * bottom_radius.
struct OvusForm {
  double bottom_radius = 1.0;
  double top_radius = 1.0;
};

/// What is iterated in a Julia set of four dimensions.
enum class JuliaFunction : std::uint8_t {
  square,
  cube,
  exponential,
  reciprocal,
  sine,
  arc_sine,
  hyperbolic_sine,
  hyperbolic_arc_sine,
  cosine,
  arc_cosine,
  hyperbolic_cosine,
  hyperbolic_arc_cosine,
  tangent,
  arc_tangent,
  hyperbolic_tangent,
  hyperbolic_arc_tangent,
  natural_logarithm,
  power,
};

/// A slice of a Julia set. [POV-Ray 3.7 manual, "Julia Fractal"]
struct JuliaFractalForm {
  enum class Algebra : std::uint8_t { quaternion, hypercomplex };

  Vec4 parameter{1.0, 0.0, 0.0, 0.0};
  Algebra algebra = Algebra::quaternion;
  JuliaFunction function = JuliaFunction::square;
  std::pair<double, double> exponent{0.0, 0.0};  ///< of JuliaFunction::power: a complex number
  int most_iterations = 20;
  double precision = 20.0;                ///< at least 1
  Vec4 slice_normal{0.0, 0.0, 0.0, 1.0};  ///< unit length; its last component is not 0
  double slice_distance = 0.0;
};

}  // namespace firstlight::render
