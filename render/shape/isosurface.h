#pragma once

#include "render/function/function.h"
#include "render/shape/container.h"
#include "render/shape/shape.h"

#include <array>
#include <optional>

namespace firstlight::render {

/// All points where a function of x, y and z is `threshold`; inside it is less. [POV-Ray 3.7 manual, "Isosurface"]
struct IsosurfaceParameters {
  static constexpr int kMostTraces = 10;

  FunctionPtr function;
  Container container;
  double threshold = 0.0;
  double accuracy = 0.001;                        ///< above 0
  double max_gradient = 1.1;                      ///< above 0
  std::optional<std::array<double, 3>> evaluate;  ///< see FieldGradient
  bool open = false;                              ///< the container's own surface is left out
  int max_trace = 1;                              ///< crossings of a ray, from 1 to kMostTraces
  int noise_generator = 2;                        ///< of the function
};

/// Cost  where the gradient is to be found, some thousand rays are sent through the container.
ShapePtr make_isosurface(const IsosurfaceParameters& parameters);

}  // namespace firstlight::render
