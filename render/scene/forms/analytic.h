#pragma once

#include "render/math/vec.h"

#include <array>
#include <cstdint>
#include <utility>

namespace firstlight::render {

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
