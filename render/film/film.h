#pragma once

#include "render/math/color.h"
#include "render/math/fixed_rgb.h"

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// The picture under construction: one exact sum a sample, and how much may still come.
///
/// Order    The sums do not depend on the order or the grouping of add() calls, bit for bit.
/// Memory   33 bytes a sample.
/// Threads  add(), mark_lit() and all that read may be called from any thread; a reader may see some of a batch's
///          contributions and not others.
class Film {
 public:
  Film(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  /// To be called before anything is added: each sample's primary ray can bring `most` at most, in steps of FixedRgb.
  void expect(std::int64_t most);
  /// `alone`: no other thread adds meanwhile, so plain additions will do.
  void add(std::span<const Contribution> contributions, bool alone);
  /// The light of the primary ray of `sample` is on the film.
  void mark_lit(std::uint32_t sample) { lit_[sample].store(1, std::memory_order_relaxed); }

  bool is_lit(int x, int y) const { return lit_[index(x, y)].load(std::memory_order_relaxed) != 0; }
  Rgb color(int x, int y) const;
  /// The most that rays still to be traced can change any channel of a pixel; 0: the pixel is complete.
  double outstanding(int x, int y) const;
  /// All colours, rows from the top.
  std::vector<Rgb> snapshot() const;

 private:
  struct alignas(32) Sample {
    std::atomic<std::int64_t> r = 0;
    std::atomic<std::int64_t> g = 0;
    std::atomic<std::int64_t> b = 0;
    std::atomic<std::int64_t> outstanding = 0;
  };
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  std::vector<Sample> samples_;
  std::vector<std::atomic<std::uint8_t>> lit_;
};

}  // namespace firstlight::render
