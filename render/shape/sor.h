#pragma once

#include "render/shape/shape.h"

#include <vector>

namespace firstlight::render {

/// A curve that rises all the way and turns around the y axis; x is the distance from the axis. The first and last
/// points only give the curve its direction. [POV-Ray 3.7 manual, "Surface of Revolution"]
struct SorParameters {
  std::vector<Vec2> points;  ///< at least 4
  bool open = false;         ///< without the two caps
};

ShapePtr make_sor(const SorParameters& parameters);

}  // namespace firstlight::render
