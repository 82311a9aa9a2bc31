#pragma once

#include "priority/scheme_input.h"
#include "render/trace/ray_task.h"

#include <algorithm>
#include <cstdint>

namespace firstlight::priority {

/// Where on the picture a ray's sample lies. Samples are numbered by pixel, row by row from the upper left.
class Pixels {
 public:
  explicit Pixels(const SchemeInput& input) : width_(static_cast<std::uint32_t>(std::max(input.width, 1))) {}

  int x(const render::RayTask& task) const { return static_cast<int>(task.sample % width_); }
  int y(const render::RayTask& task) const { return static_cast<int>(task.sample / width_); }

 private:
  std::uint32_t width_;
};

}  // namespace firstlight::priority
