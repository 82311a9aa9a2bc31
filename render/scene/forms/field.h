#pragma once

#include "render/function/function.h"
#include "render/math/vec.h"

#include <array>
#include <optional>
#include <variant>

namespace firstlight::render {

struct ContainerBox {
  Vec3 low{-1.0, -1.0, -1.0};
  Vec3 high{1.0, 1.0, 1.0};
};
struct ContainerSphere {
  Vec3 center{0.0, 0.0, 0.0};
  double radius = 1.0;
};
/// Where a surface that is given by functions is looked for.
using Container = std::variant<ContainerBox, ContainerSphere>;

/// All points where a function of x, y and z is `threshold`; inside it is less. [POV-Ray 3.7 manual, "Isosurface"]
struct IsosurfaceForm {
  static constexpr int kMostTraces = 10;

  FunctionPtr function;
  Container container;
  double threshold = 0.0;
  double accuracy = 0.001;
  double max_gradient = 1.1;
  /// The gradient is found while rendering: its start, and the factors by which it grows and shrinks.
  std::optional<std::array<double, 3>> evaluate;
  bool open = false;  ///< the container's own surface is left out
  int max_trace = 1;  ///< crossings of a ray; kMostTraces: all
};

/// Points that three functions of u and v give. [POV-Ray 3.7 manual, "Parametric"]
struct ParametricForm {
  static constexpr int kDeepestPrecompute = 20;

  std::array<FunctionPtr, 3> functions;
  Vec2 low{0.0, 0.0};  ///< of u and v
  Vec2 high{1.0, 1.0};
  Container container;
  double accuracy = 0.001;
  double max_gradient = 1.0;
  int precompute_depth = 0;  ///< of the coordinates below; 0: nothing is worked out before rendering
  std::array<bool, 3> precompute{false, false, false};
};

}  // namespace firstlight::render
