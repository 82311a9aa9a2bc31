#pragma once

#include "render/function/function.h"
#include "render/shape/container.h"
#include "render/shape/shape.h"

#include <array>

namespace firstlight::render {

/// Points that three functions of u and v give. [POV-Ray 3.7 manual, "Parametric"]
struct ParametricParameters {
  static constexpr int kDeepestPrecompute = 20;

  std::array<FunctionPtr, 3> functions;  ///< of u, v and one more argument
  Vec2 low{0.0, 0.0};                    ///< of u and v
  Vec2 high{1.0, 1.0};
  Container container;
  double accuracy = 0.001;
  double max_gradient = 1.0;  ///< what the functions change at most with u or v
  int precompute_depth = 0;   ///< of the coordinates below; 0: none
  std::array<bool, 3> precompute{false, false, false};
  int noise_generator = 2;  ///< of the functions
};

/// A surface without an inside.
/// Cost    of making: up to some ten thousand evaluations, and as many as `precompute` asks for.
/// Memory  16 bytes for each rectangle of u and v whose bounds are kept, 2^precompute_depth of each coordinate.
ShapePtr make_parametric(const ParametricParameters& parameters);

}  // namespace firstlight::render
