#include "render/film/place_sampler.h"

#include <algorithm>
#include <limits>
#include <new>
#include <numeric>

namespace firstlight::render {
namespace {

std::uint32_t room_for(std::uint32_t pixels) {
  constexpr std::uint32_t kLeast = 1u << 18;
  constexpr std::uint32_t kMost = 1u << 22;
  return std::min(std::clamp(pixels, kLeast, kMost), std::numeric_limits<std::uint32_t>::max() - pixels);
}

void make_room(Film& film) {
  constexpr std::uint32_t kSmall = 1u << 12;  // still more than a pixel's grid needs
  for (std::uint32_t room = room_for(film.pixels()); room >= kSmall; room /= 2) {
    try {
      return film.begin_refinement(room);
    } catch (const std::bad_alloc&) {
    }
  }
  throw std::bad_alloc();
}

}  // namespace

PlaceSampler::PlaceSampler(Film& film, const std::optional<BlurSettings>& blur) : film_(film) {
  if (blur) rule_.emplace(*blur);
  make_room(film);
}

void PlaceSampler::clear() {
  places_.clear();
  open_.clear();
  round_begin_ = round_end_ = 0;
  are_pixels_ = false;
}

std::uint32_t PlaceSampler::add(const PicturePoint& place, std::uint32_t pixel) {
  places_.push_back({place.x + 0.5, place.y + 0.5, pixel});
  return size() - 1;
}

PlaceSampler::Place PlaceSampler::place(std::uint32_t number) const {
  if (!are_pixels_) return places_[number];
  const auto width = static_cast<std::uint32_t>(film_.width());
  return {number % width + offset_, number / width + offset_, number};
}

void PlaceSampler::open_all(std::size_t count) {
  sums_.assign(count, PlaceSums());
  open_.resize(count);
  std::iota(open_.begin(), open_.end(), 0u);
  round_begin_ = round_end_ = 0;
}

std::span<const SamplePoint> PlaceSampler::begin() {
  if (rule_) {
    open_all(places_.size());
    return next_round();
  }
  points_.clear();
  owners_.clear();
  for (const auto& [x, y, pixel] : places_) {
    points_.push_back({x, y, film_.pixels() + static_cast<std::uint32_t>(points_.size())});
    owners_.push_back(pixel);
  }
  film_.begin_samples(owners_);
  return points_;
}

std::span<const SamplePoint> PlaceSampler::begin_pixels(double offset, bool is_last) {
  places_.clear();
  are_pixels_ = true;
  offset_ = offset;
  is_last_ = is_last;
  open_all(film_.pixels());
  pixels_.resize(is_last ? 0 : film_.pixels());
  for (std::uint32_t pixel = 0; pixel < film_.pixels(); ++pixel) {
    sums_[pixel].add(film_.sample(pixel));
    show(pixel, rule_->most() == 1);
  }
  if (rule_->most() == 1) open_.clear();
  return next_round();
}

std::span<const SamplePoint> PlaceSampler::more() {
  if (!rule_) return {};
  take_in();
  return next_round();
}

// Round after round for all places, in portions where the film has no room for all of them.
std::span<const SamplePoint> PlaceSampler::next_round() {
  if (round_end_ == open_.size() && round_end_ > 0) {
    std::erase_if(open_, [this](std::uint32_t number) { return rule_->is_enough(sums_[number]); });
    round_end_ = 0;
  }
  round_begin_ = round_end_;
  points_.clear();
  owners_.clear();
  for (; round_end_ < open_.size(); ++round_end_) {
    const auto count = static_cast<std::uint32_t>(sums_[open_[round_end_]].count);
    const auto stop = static_cast<std::uint32_t>(rule_->next_stop(static_cast<int>(count)));
    if (points_.size() + (stop - count) > film_.room()) break;
    const auto [x, y, pixel] = place(open_[round_end_]);
    for (std::uint32_t number = count; number < stop; ++number) {
      points_.push_back({x, y, film_.pixels() + static_cast<std::uint32_t>(points_.size()), number});
      owners_.push_back(pixel);
    }
  }
  if (!points_.empty()) film_.begin_samples(owners_);
  return points_;
}

void PlaceSampler::take_in() {
  std::uint32_t sample = film_.pixels();
  for (; round_begin_ < round_end_; ++round_begin_) {
    const std::uint32_t number = open_[round_begin_];
    PlaceSums& sums = sums_[number];
    for (const int stop = rule_->next_stop(sums.count); sums.count < stop;) sums.add(film_.sample(sample++));
    if (are_pixels_) show(number, rule_->is_enough(sums));
  }
}

void PlaceSampler::show(std::uint32_t pixel, bool is_enough) {
  const PlaceSums& sums = sums_[pixel];
  const PixelColor mean = sums.mean();
  if (!is_last_) {
    pixels_[pixel] = mean;
    film_.refine(pixel, mean, 1.0f);
  } else {
    film_.refine(pixel, mean,
                 is_enough ? 0.0f : 1.0f - static_cast<float>(sums.count) / static_cast<float>(rule_->most()));
  }
}

PixelColor PlaceSampler::color(std::uint32_t number) const {
  return rule_ ? sums_[number].mean() : film_.sample(film_.pixels() + number);
}

PixelColor PlaceSampler::pixel_color(std::uint32_t pixel) const { return rule_ ? pixels_[pixel] : film_.sample(pixel); }

void PlaceSampler::settle(std::uint32_t pixel) {
  if (rule_) {
    film_.refine(pixel, pixels_[pixel], 0.0f);
  } else {
    film_.settle(pixel);
  }
}

}  // namespace firstlight::render
