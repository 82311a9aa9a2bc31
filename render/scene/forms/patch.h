#pragma once

#include "render/math/vec.h"

#include <array>

namespace firstlight::render {

/// A Bezier patch of 4 by 4 control points. [POV-Ray 3.7 manual, "Bicubic Patch"]
struct BicubicPatchForm {
  int type = 0;           ///< 0: subdivided while rays are traced; 1: subdivided before
  double flatness = 0.0;  ///< subdivision stops below it
  int u_steps = 0;        ///< most halvings each way
  int v_steps = 0;
  double accuracy = 0.01;
  std::array<Vec2, 4> uv{Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(1.0, 1.0), Vec2(0.0, 1.0)};  ///< of the corners
  std::array<std::array<Vec3, 4>, 4> points{};
};

}  // namespace firstlight::render
