#pragma once

#include "render/shape/shape.h"

#include <array>

namespace firstlight::render {

/// A Bezier patch of 4 by 4 control points. [POV-Ray 3.7 manual, "Bicubic Patch"]
struct BicubicPatchParameters {
  using Points = std::array<std::array<Vec3, 4>, 4>;

  double flatness = 0.0;  ///< subdivision stops below it
  int u_steps = 0;        ///< most halvings each way
  int v_steps = 0;
  std::array<Vec2, 4> uv{Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(1.0, 1.0), Vec2(0.0, 1.0)};  ///< of the corners
  Points points{};
};

ShapePtr make_bicubic_patch(const BicubicPatchParameters& parameters);

}  // namespace firstlight::render
