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
        over_width_(~std::uint64_t{0} / width_ + 1),
        count_(width_ * static_cast<std::uint32_t>(std::max(input.height, 1))) {}

  struct Place {
    int x;
    int y;
  };
  Place place(const render::RayTask& task) const {
    const std::uint32_t number = pixel(task);
    const std::uint32_t row = row_of(number);
    return {static_cast<int>(number - row * width_), static_cast<int>(row)};
  }
  int x(const render::RayTask& task) const { return place(task).x; }
  int y(const render::RayTask& task) const { return place(task).y; }

 private:
  std::uint32_t pixel(const render::RayTask& task) const {
    return task.sample < count_ || film_ == nullptr ? task.sample : film_->pixel_of(task.sample);
  }

  /// number / width_, by a multiplication: 2^64 / width_ is rounded up by less than one, which is too little to matter
  /// when multiplied with 32 bits.
  std::uint32_t row_of(std::uint32_t number) const {
    if (width_ == 1) return number;
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::uint32_t>(Wide{number} * over_width_ >> 64);
  }

  const render::Film* film_;
  std::uint32_t width_;
  std::uint64_t over_width_;
  std::uint32_t count_;
};

}  // namespace firstlight::priority
