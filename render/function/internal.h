#pragma once

#include "render/function/function.h"

#include <cstddef>
#include <span>

namespace firstlight::render {

/// A built-in function of the scene language, which scenes reach by its number: `internal(61)` is a sphere. The
/// standard include file functions.inc gives them names.
struct InternalFunction {
  /// `p` is x, y, z and the function's own parameters, which follow.
  using Formula = double (*)(const double* p, const Evaluation& evaluation);
  std::size_t number;
  Formula formula;
  std::size_t parameters;  ///< x, y and z among them
};

// The functions by what they are made of, each list in rising order of numbers.
std::span<const InternalFunction> internal_noise();   ///< internal_noise.cpp: noise and fractals of it
std::span<const InternalFunction> internal_plane();   ///< internal_plane.cpp: curves of the plane, turned or drawn out
std::span<const InternalFunction> internal_solids();  ///< internal_solids.cpp: by distances, exponentials, angles
std::span<const InternalFunction> internal_surfaces();  ///< internal_surfaces.cpp: algebraic surfaces

/// The function `internal(number)`; null when there is none.
FunctionPtr make_internal(std::size_t number);

}  // namespace firstlight::render
