#pragma once

#include "render/film/film.h"
#include "render/film/jitter.h"
#include "render/film/sample_rounds.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// Samples that are traced together, no more than the film has room for.
class SampleRound {
 public:
  explicit SampleRound(Film& film) : film_(film) {}

  void clear() {
    points_.clear();
    owners_.clear();
  }
  bool has_room(std::size_t count) const { return points_.size() + count <= film_.room(); }
  /// Returns the sample's number in this round. Pre: has_room(1).
  std::uint32_t add(const PicturePoint& place, std::uint32_t pixel) {
    const auto number = static_cast<std::uint32_t>(points_.size());
    points_.push_back({place.x + 0.5, place.y + 0.5, film_.pixels() + number});
    owners_.push_back(pixel);
    return number;
  }
  /// Makes the samples on the film.
  std::span<const SamplePoint> begin() {
    film_.begin_samples(owners_);
    return points_;
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  /// Of a sample that has been traced.
  Rgb color(std::uint32_t number) const { return film_.sample_color(film_.pixels() + number); }

 private:
  Film& film_;
  std::vector<SamplePoint> points_;
  std::vector<std::uint32_t> owners_;
};

}  // namespace firstlight::render
