#pragma once

#include "render/shape/shape.h"

#include <complex>
#include <cstdint>

namespace firstlight::render {

/// Functions that are iterated in a Julia set of four dimensions.
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

/// A slice of a Julia set: the points (x, y, z, w) of it on a hyperplane, seen at (x, y, z). [POV-Ray 3.7 manual, "Julia
/// Fractal"]
struct JuliaFractalParameters {
  enum class Algebra : std::uint8_t { quaternion, hypercomplex };
  static constexpr int kMostIterations = 100'000;

  Vec4 parameter{1.0, 0.0, 0.0, 0.0};
  Algebra algebra = Algebra::quaternion;  ///< of quaternions there are only the square and the cube
  JuliaFunction function = JuliaFunction::square;
  std::complex<double> exponent;  ///< of JuliaFunction::power
  int most_iterations = 20;       ///< from 1 to kMostIterations
  double precision = 20.0;        ///< at least 1: steps of a ray in a unit
  Vec4 slice_normal{0.0, 0.0, 0.0, 1.0};  ///< unit length; its last component is not 0
  double slice_distance = 0.0;
};

ShapePtr make_julia_fractal(const JuliaFractalParameters& parameters);

}  // namespace firstlight::render
