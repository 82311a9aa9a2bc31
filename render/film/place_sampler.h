#pragma once

#include "render/film/blur.h"
#include "render/film/film.h"
#include "render/film/jitter.h"
#include "render/film/sample_rounds.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace firstlight::render {

/// Finds the colours of places of a picture, many at once: by a sample each, or with focal blur by rounds of samples,
/// until each place has enough.
///
/// Memory   The film gets room for as many samples as it has pixels, at least 2^18 and at most 2^22; rounds are no
///          larger.
///          With blur 56 bytes a pixel. Throws std::bad_alloc when there is not even room for few samples.
/// Threads  One thread calls; others may read the film.
class PlaceSampler {
 public:
  /// To be made before anything is added to `film`. `blur`: none where a sample is all that a place needs.
  PlaceSampler(Film& film, const std::optional<BlurSettings>& blur);

  bool has_blur() const { return rule_.has_value(); }
  /// The next samples of places that have not got enough, to be called when those before are complete; empty: all have.
  std::span<const SamplePoint> more();

  // ---- Places between the pixels
  void clear();
  bool has_room(std::size_t count) const { return places_.size() + count <= film_.room(); }
  /// Returns the place's number. `pixel`: that it belongs to. Pre: has_room(1).
  std::uint32_t add(const PicturePoint& place, std::uint32_t pixel);
  std::uint32_t size() const { return static_cast<std::uint32_t>(places_.size()); }
  /// The first samples of the places. Without blur each place has one, in their order, from the film's pixels() on.
  std::span<const SamplePoint> begin();
  /// The colour of a place that has all its samples.
  PixelColor color(std::uint32_t number) const;

  // ---- Places of the pixels
  /// Lets the places of all pixels, whose first samples are complete, get the rest of theirs. `offset`: of a place in
  /// its pixel. `is_last`: the picture is complete then. Pre: there is blur.
  std::span<const SamplePoint> begin_pixels(double offset, bool is_last);
  /// The colour of a pixel's place. Pre: with blur, more() has come to the end of begin_pixels().
  PixelColor pixel_color(std::uint32_t pixel) const;
  /// The pixel is the colour of its place, and complete. Pre: as above.
  void settle(std::uint32_t pixel);

 private:
  struct Place {
    double x;
    double y;
    std::uint32_t pixel;
  };
  Place place(std::uint32_t number) const;
  void open_all(std::size_t count);
  std::span<const SamplePoint> next_round();
  void take_in();
  /// Lets the film show what a pixel is so far.
  void show(std::uint32_t pixel, bool is_enough);

  Film& film_;
  std::optional<BlurRule> rule_;
  std::vector<Place> places_;
  std::vector<SamplePoint> points_;    ///< of the round
  std::vector<std::uint32_t> owners_;  ///< pixels of points_
  // With blur only:
  std::vector<PlaceSums> sums_;      ///< of each place
  std::vector<std::uint32_t> open_;  ///< places that want samples
  std::size_t round_begin_ = 0;      ///< in open_, of those whose samples are being traced
  std::size_t round_end_ = 0;
  bool are_pixels_ = false;  ///< the places, by number
  double offset_ = 0.0;      ///< of those
  bool is_last_ = false;
  std::vector<PixelColor> pixels_;  ///< colours of the pixels' places
};

/// The samples that a picture with blur needs after the first of each pixel.
class PixelBlur final : public SampleRounds {
 public:
  /// As PlaceSampler::begin_pixels(). Pre: `places` outlives it.
  PixelBlur(PlaceSampler& places, double offset, bool is_last) : places_(places), offset_(offset), is_last_(is_last) {}

  std::span<const SamplePoint> next() override {
    if (has_begun_) return places_.more();
    has_begun_ = true;
    return places_.begin_pixels(offset_, is_last_);
  }

 private:
  PlaceSampler& places_;
  const double offset_;
  const bool is_last_;
  bool has_begun_ = false;
};

}  // namespace firstlight::render
