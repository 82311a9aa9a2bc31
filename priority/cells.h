#pragma once

#include "priority/pixels.h"

#include <algorithm>
#include <cstddef>

namespace firstlight::priority {

/// The picture in squares of pixels, small enough that neighbours see much the same, and not too many for a table.
class Cells {
 public:
  explicit Cells(const SchemeInput& input) : pixels_(input) {
    while (squares(input.width) * squares(input.height) > kMost) ++shift_;
    columns_ = squares(input.width);
    count_ = columns_ * squares(input.height);
  }

  std::size_t count() const { return count_; }
  std::size_t of(const render::RayTask& task) const {
    const auto [x, y] = pixels_.place(task);
    const std::size_t cell =
        (static_cast<std::size_t>(y) >> shift_) * columns_ + (static_cast<std::size_t>(x) >> shift_);
    return std::min(cell, count_ - 1);
  }

 private:
  static constexpr std::size_t kMost = 32768;

  std::size_t squares(int length) const { return (static_cast<std::size_t>(std::max(length, 1)) >> shift_) + 1; }

  Pixels pixels_;
  int shift_ = 5;
  std::size_t columns_ = 0;
  std::size_t count_ = 0;
};

}  // namespace firstlight::priority
