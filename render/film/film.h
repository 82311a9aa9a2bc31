#pragma once

#include "render/math/color.h"
#include "render/math/fixed_rgb.h"
#include "render/math/pixel_color.h"
#include "render/math/zeroed_pages.h"

#include <tbb/spin_mutex.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// The picture under construction: one exact sum a sample, and how much may still come.
///
/// Samples  The first of each pixel are numbered along the rows from the top; what lies beyond them is anti-aliasing's.
/// Order    The sums do not depend on the order or the grouping of add() calls, bit for bit.
/// Memory   33 bytes a sample; with anti-aliasing up to 21 more a pixel, and 36 for each sample there is room for;
///          with an alpha channel 8 more a sample and 4 a pixel. That of the pixels is taken from the system by
///          expect(), the rest as it is used.
/// Threads  add(), mark_lit() and all that read may be called from any thread; a reader may see some of a batch's
///          contributions and not others. The rest: one thread, while nobody adds.
class Film {
 public:
  Film(int width, int height, bool has_alpha = false);

  /// Whether it adds up what shows through, too.
  bool has_alpha() const { return has_alpha_; }
  int width() const { return width_; }
  int height() const { return height_; }
  std::uint32_t pixels() const { return static_cast<std::uint32_t>(lit_.size()); }

  /// To be called before anything is added: each sample's primary ray can bring `most` at most, in steps of FixedRgb.
  void expect(std::int64_t most) { expect(most, -most); }
  /// The same where no sample ends below `least`.
  void expect(std::int64_t most, std::int64_t least);
  /// Deals the samples out among `threads` that will add at the same time, one if this is never called: bands of rows,
  /// turn by turn. Anyone may add to any sample, but who keeps to its own meets no other thread there, neither at a
  /// lock nor in a cache. Pre: nobody adds meanwhile.
  void deal_out(int threads);
  /// The thread that a sample was dealt to, from 0.
  std::size_t owner_of(std::uint32_t sample) const {
    const std::size_t range = sample >> range_shift_;
    return range < owners_.size() ? owners_[range] : range % threads_;
  }
  void add(std::span<const Contribution> contributions);
  /// The same of what shows through, before the light of the same rays is added. Without an alpha channel nothing
  /// happens.
  void add(std::span<const Clearness> clearness);
  /// Asks the processor to have the sample's sums at hand, for they lie anywhere in memory.
  void fetch(std::uint32_t sample) const { __builtin_prefetch(&samples_[sample], 1); }
  /// The light of the primary ray of `sample` is on the film.
  void mark_lit(std::uint32_t sample) {
    if (sample < lit_.size()) store(lit_[sample], std::uint8_t{1});
  }

  bool is_lit(int x, int y) const { return load(lit_[index(x, y)]) != 0; }
  /// The colour of a pixel, as far as it is: its first sample, or what anti-aliasing has made of several.
  PixelColor pixel(int x, int y) const;
  Rgb color(int x, int y) const { return pixel(x, y).light; }
  /// The most that rays still to be traced can change any channel of a pixel; 0: the pixel is complete.
  double outstanding(int x, int y) const;
  /// Whether all pixels are.
  bool is_complete() const;
  /// The colours of a row. Pre: as many as the picture is wide.
  void row(int y, std::span<Rgb> colors) const;
  void row(int y, std::span<PixelColor> pixels) const;
  /// All colours, rows from the top.
  std::vector<Rgb> snapshot() const;

  PixelColor sample(std::uint32_t sample) const { return {sample_color(sample), sample_clearness(sample)}; }
  Rgb sample_color(std::uint32_t sample) const;
  /// The number, row by row, of the pixel that a sample belongs to.
  std::uint32_t pixel_of(std::uint32_t sample) const {
    return sample < pixels() ? sample : pixel_of_more_[sample - pixels()];
  }

  // ---- For anti-aliasing
  /// From now on no pixel is complete before one of the functions below says so. Makes room for `room` samples beyond
  /// the pixels; throws std::bad_alloc. Pre: nothing has been added.
  void begin_refinement(std::uint32_t room);
  /// The samples beyond the pixels begin anew: one for each of `pixels`, to which they belong, numbered from pixels().
  /// Pre: no more than there is room for.
  void begin_samples(std::span<const std::uint32_t> pixels);
  std::uint32_t room() const { return static_cast<std::uint32_t>(pixel_of_more_.size()); }
  /// The pixel is its first sample, and no more are needed.
  void settle(std::uint32_t pixel);
  /// The pixel has a colour of several samples; `open`, of 1, is the share of it that still changes.
  void refine(std::uint32_t pixel, const PixelColor& color, float open);
  /// The pixel will be the mean of its first sample and `count` samples from `first` on, and is meanwhile that of those
  /// that are complete. Pre: `count` is the same for all pixels, and more than 0.
  void average(std::uint32_t pixel, std::uint32_t first, std::uint32_t count);
  PixelColor refined_color(std::uint32_t pixel) const {
    return {refined_[pixel].color(), has_alpha_ ? load(refined_clearness_[pixel]) : 0.0f};
  }
  float open_share(std::uint32_t pixel) const { return load(refined_[pixel].open); }

 private:
  // These begin as zeros, and threads change and read them as std::atomic would.
  struct alignas(32) Sample {
    std::int64_t r, g, b;
    std::int64_t change;  ///< of the most that may still come, most_ at first
  };
  enum class State : std::uint8_t { undecided, first_sample, averaged, refined };
  struct Refined {
    float r, g, b;
    float open;

    Rgb color() const { return {load(r), load(g), load(b)}; }
  };
  template <class T>
  static T load(const T& number, std::memory_order order = std::memory_order_relaxed) {
    return std::atomic_ref(const_cast<T&>(number)).load(order);
  }
  template <class T>
  static void store(T& number, T value, std::memory_order order = std::memory_order_relaxed) {
    std::atomic_ref(number).store(value, order);
  }

  /// Held while samples of one owner change.
  struct alignas(64) Lock {
    tbb::spin_mutex mutex;
  };
  static constexpr std::size_t kMostOwners = 64;  ///< threads beyond them share
  static constexpr std::size_t kMostAtOnce = 1024;
  void add_plainly(std::span<const Contribution> contributions);
  void add_plainly(const Contribution& contribution);
  void add_by_owners(std::span<const Contribution> contributions);

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  std::int64_t sample_outstanding(std::uint32_t sample) const {
    return FixedRgb::sum(most_, load(samples_[sample].change));
  }
  State state(std::size_t pixel) const {
    return states_.empty() ? State::first_sample : load(states_[pixel], std::memory_order_acquire);
  }

  /// The most that a mean of samples can be away from `color` in any channel, if nothing is known of them.
  double most_change(const Rgb& color) const;
  PixelColor mean_so_far(std::uint32_t pixel) const;
  double most_change_of_mean(std::uint32_t pixel) const;
  float sample_clearness(std::uint32_t sample) const {
    return has_alpha_ ? static_cast<float>(FixedRgb::to_double(load(clearness_[sample]))) : 0.0f;
  }

  int width_;
  int height_;
  bool has_alpha_;
  ZeroedPages<Sample> samples_;
  ZeroedPages<std::int64_t> clearness_;  ///< of each sample; empty without an alpha channel
  std::size_t threads_ = 1;
  std::uint32_t range_shift_ = 0;     ///< samples are dealt out in ranges of 2^range_shift_
  std::vector<std::uint8_t> owners_;  ///< of each range of the pixels
  std::array<Lock, kMostOwners> locks_;
  ZeroedPages<std::uint8_t> lit_;
  std::int64_t most_ = 0;   // that a sample can end with
  std::int64_t least_ = 0;  // the same from below
  // The rest is of anti-aliasing; empty without it.
  ZeroedPages<State> states_;
  ZeroedPages<Refined> refined_;
  ZeroedPages<float> refined_clearness_;  ///< empty without an alpha channel
  ZeroedPages<std::uint32_t> first_of_mean_;
  std::atomic<std::uint32_t> count_of_mean_ = 0;
  ZeroedPages<std::uint32_t> pixel_of_more_;
};

}  // namespace firstlight::render
