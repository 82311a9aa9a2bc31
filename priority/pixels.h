#pragma once

#include "priority/scheme_input.h"
#include "render/trace/ray_task.h"

#include <algorithm>
#include <cstdint>

namespace firstlight::priority {

/// Where on the picture a ray's sample lies. The first samples of the pixels are numbered row by row from the upper
/// left.
class Pixels {
 public:
  explicit Pixels(const SchemeInput& input)
      : film_(input.film),
        width_(static_cast<std::uint32_t>(std::max(input.width, 1))),
        count_(width_ * static_cast<std::uint32_t>(std::max(input.height, 1))) {}

  struct Place {
    int x;
    int y;
  };
  Place place(const render::RayTask& task) const {
    const std::uint32_t number = pixel(task);
    return {static_cast<int>(number % width_), static_cast<int>(number / width_)};
  }
  int x(const render::RayTask& task) const { return place(task).x; }
  int y(const render::RayTask& task) const { return place(task).y; }

 private:
  std::uint32_t pixel(const render::RayTask& task) const {
    return task.sample < count_ || film_ == nullptr ? task.sample : film_->pixel_of(task.sample);
  }

  const render::Film* film_;
  std::uint32_t width_;
  std::uint32_t count_;
};

}  // namespace firstlight::priority
