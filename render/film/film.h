#pragma once

#include "render/math/color.h"

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// Light to be added to a sample; negative where a feeler takes light back.
struct Contribution {
  std::uint32_t sample = 0;
  Rgb light;
};

/// A colour in fixed point, 2^-36 a step: adding is exact, so the order of adding does not show.
struct FixedRgb {
  std::int64_t r = 0;
  std::int64_t g = 0;
  std::int64_t b = 0;

  /// Rounds to the nearest step; components beyond 2^24 in size are cut there, not-a-number is 0.
  static FixedRgb from(const Rgb& color);
  Rgb to_rgb() const;
  FixedRgb& operator+=(const FixedRgb& other);
};

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
