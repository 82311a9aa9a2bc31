#pragma once

#include "render/function/function.h"

#include <cstddef>
#include <span>

namespace firstlight::render {

/// A built-in function of the scene language, which scenes reach by its number: `internal(61)` is a sphere. The
/// standard include file functions.inc gives them names.
struct InternalFunction {
  std::size_t number;
  std::size_t parameters;  ///< x, y and z among them
  /// The value at one point: `p` is x, y, z and the function's own parameters, which follow.
  double (*formula)(const double* p, int noise_generator);
};

/// Some built-in functions in rising order of numbers.
struct InternalFamily {
  std::span<const InternalFunction> functions;
  /// Values of the function `number` at many points, as for Function::evaluate_many.
  void (*many)(std::size_t number, const double* const* arguments, double* result, std::size_t count,
               int noise_generator);
};

// The functions by what they are made of.
InternalFamily internal_noise();     ///< internal_noise.cpp: noise and fractals of it
InternalFamily internal_plane();     ///< internal_plane.cpp: curves of the plane, turned or drawn out
InternalFamily internal_solids();    ///< internal_solids.cpp: by distances, exponentials, angles
InternalFamily internal_surfaces();  ///< internal_surfaces.cpp: algebraic surfaces

/// The function `internal(number)`; null when there is none.
FunctionPtr make_internal(std::size_t number);

}  // namespace firstlight::render
