#pragma once

#include "render/math/color.h"
#include "render/math/fixed_rgb.h"

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// The picture under construction: one exact sum a sample.
///
/// Order    The sums do not depend on the order or the grouping of add() calls, bit for bit.
/// Memory   24 bytes a sample.
/// Threads  add() and color() from any thread; a reader may see some of a batch's contributions and not others.
class Film {
 public:
  Film(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  /// `alone`: no other thread adds meanwhile, so plain additions will do.
  void add(std::span<const Contribution> contributions, bool alone);
  Rgb color(int x, int y) const;
  /// All colours, rows from the top.
  std::vector<Rgb> snapshot() const;

 private:
  int width_;
  int height_;
  std::vector<std::atomic<std::int64_t>> sums_;  // r, g, b of each sample
};

}  // namespace firstlight::render
