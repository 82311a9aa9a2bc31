#include "render/film/film.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

namespace firstlight::render {

Film::Film(int width, int height, bool has_alpha)
    : width_(width),
      height_(height),
      has_alpha_(has_alpha),
      samples_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      clearness_(has_alpha ? samples_.size() : 0),
      lit_(samples_.size()) {}

void Film::expect(std::int64_t most, std::int64_t least) {
  most_ = most;
  least_ = least;
  samples_.touch(lit_.size());
  lit_.touch(lit_.size());
  if (has_alpha_) clearness_.touch(lit_.size());
}

void Film::deal_out(int threads) {
  constexpr std::size_t kBands = 4;      // of each thread, so that all get some of what is hard
  constexpr std::size_t kRows = 16;      // of a band, at least and as a multiple: primary rays come in tiles of so many
  constexpr std::size_t kRanges = 4096;  // few enough to stay in the nearest cache
  threads_ = std::clamp<std::size_t>(static_cast<std::size_t>(threads), 1, kMostOwners);
  const std::size_t rows =
      std::max<std::size_t>(static_cast<std::size_t>(height_) / (kBands * threads_ * kRows), 1) * kRows;
  const std::size_t band = rows * static_cast<std::size_t>(width_);
  range_shift_ = static_cast<std::uint32_t>(std::bit_width((lit_.size() - 1) / kRanges));
  owners_.resize(((lit_.size() - 1) >> range_shift_) + 1);
  for (std::size_t range = 0; range < owners_.size(); ++range) {
    owners_[range] = static_cast<std::uint8_t>((range << range_shift_) / band % threads_);
  }
}

inline void Film::add_plainly(const Contribution& contribution) {
  const auto add = [](std::int64_t& sum, std::int64_t change) { store(sum, FixedRgb::sum(load(sum), change)); };
  Sample& sample = samples_[contribution.sample];
  add(sample.r, contribution.light.r);
  add(sample.g, contribution.light.g);
  add(sample.b, contribution.light.b);
  add(sample.change, contribution.outstanding);
}

void Film::add_plainly(std::span<const Contribution> contributions) {
  for (const Contribution& contribution : contributions) add_plainly(contribution);
}

// Four atomic additions a contribution would cost several times what a lock a batch does.
void Film::add(std::span<const Contribution> contributions) {
  if (threads_ == 1) return add_plainly(contributions);
  while (!contributions.empty()) {
    const std::size_t owner = owner_of(contributions.front().sample);
    const auto other =
        std::ranges::find_if(contributions, [&](const Contribution& c) { return owner_of(c.sample) != owner; });
    if (other == contributions.end()) {
      const tbb::spin_mutex::scoped_lock lock(locks_[owner].mutex);
      return add_plainly(contributions);
    }
    const auto part = contributions.first(std::min(contributions.size(), kMostAtOnce));
    add_by_owners(part);
    contributions = contributions.subspan(part.size());
  }
}

void Film::add(std::span<const Clearness> clearness) {
  if (!has_alpha_) return;
  for (const Clearness& share : clearness) {
    std::atomic_ref(clearness_[share.sample]).fetch_add(share.steps, std::memory_order_relaxed);
  }
}

void Film::add_by_owners(std::span<const Contribution> contributions) {
  std::array<std::uint16_t, kMostOwners + 1> end{};  // in `order`, first of the owner before, then of the owner itself
  for (const Contribution& contribution : contributions) ++end[owner_of(contribution.sample) + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::array<std::uint16_t, kMostAtOnce> order;
  for (std::size_t i = 0; i < contributions.size(); ++i) {
    order[end[owner_of(contributions[i].sample)]++] = static_cast<std::uint16_t>(i);
  }
  std::size_t begin = 0;
  for (std::size_t owner = 0; owner < threads_; ++owner) {
    if (begin == end[owner]) continue;
    const tbb::spin_mutex::scoped_lock lock(locks_[owner].mutex);
    for (; begin < end[owner]; ++begin) add_plainly(contributions[order[begin]]);
  }
}

PixelColor Film::pixel(int x, int y) const {
  const auto pixel = static_cast<std::uint32_t>(index(x, y));
  switch (state(pixel)) {
    case State::averaged:
      return mean_so_far(pixel);
    case State::refined:
      return refined_color(pixel);
    case State::first_sample:
    case State::undecided:
      break;
  }
  return sample(pixel);
}

Rgb Film::sample_color(std::uint32_t sample) const {
  const Sample& sums = samples_[sample];
  return FixedRgb{load(sums.r), load(sums.g), load(sums.b)}.to_rgb();
}

double Film::outstanding(int x, int y) const {
  const auto pixel = static_cast<std::uint32_t>(index(x, y));
  switch (state(pixel)) {
    case State::undecided:
      return most_change(sample_color(pixel));
    case State::averaged:
      return most_change_of_mean(pixel);
    case State::refined:
      return open_share(pixel) * (FixedRgb::to_double(most_) - FixedRgb::to_double(least_));
    case State::first_sample:
      break;
  }
  return FixedRgb::to_double(sample_outstanding(pixel));
}

double Film::most_change(const Rgb& color) const {
  const auto [low, high] = std::minmax({color.x, color.y, color.z});
  return std::max(FixedRgb::to_double(most_) - static_cast<double>(low),
                  static_cast<double>(high) - FixedRgb::to_double(least_));
}

PixelColor Film::mean_so_far(std::uint32_t pixel) const {
  PixelColor sum = sample(pixel);
  int count = 1;
  const std::uint32_t first = first_of_mean_[pixel];
  const std::uint32_t samples = count_of_mean_.load(std::memory_order_relaxed);
  for (std::uint32_t number = first; number < first + samples; ++number) {
    if (sample_outstanding(number) != 0) continue;
    sum += sample(number);
    ++count;
  }
  return mean_of(sum, count);
}

double Film::most_change_of_mean(std::uint32_t pixel) const {
  std::int64_t outstanding = 0;
  Rgb sum = sample_color(pixel);
  float largest = max_magnitude(sum);
  const std::uint32_t first = first_of_mean_[pixel];
  const std::uint32_t samples = count_of_mean_.load(std::memory_order_relaxed);
  for (std::uint32_t sample = first; sample < first + samples; ++sample) {
    outstanding = FixedRgb::sum(outstanding, sample_outstanding(sample));
    const Rgb color = sample_color(sample);
    largest = std::max(largest, max_magnitude(color));
    sum += color;
  }
  if (outstanding == 0) return 0.0;
  const double count = samples + 1.0;
  const double most = FixedRgb::to_double(outstanding);
  const Rgb color = mean_so_far(pixel).light;
  const double to_mean = max_magnitude(color - sum / static_cast<float>(count));
  // Sums and means are in single precision, the last ones too, whose samples may be brighter by `most`.
  const double rounding = (count + 2.0) * std::numeric_limits<float>::epsilon() * (static_cast<double>(largest) + most);
  return std::min(to_mean + most / count + rounding, most_change(color));
}

bool Film::is_complete() const {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (!is_lit(x, y) || outstanding(x, y) != 0.0) return false;
    }
  }
  return true;
}

void Film::row(int y, std::span<Rgb> colors) const {
  for (int x = 0; x < width_; ++x) colors[static_cast<std::size_t>(x)] = color(x, y);
}

void Film::row(int y, std::span<PixelColor> pixels) const {
  for (int x = 0; x < width_; ++x) pixels[static_cast<std::size_t>(x)] = pixel(x, y);
}

std::vector<Rgb> Film::snapshot() const {
  std::vector<Rgb> picture(lit_.size());
  for (int y = 0; y < height_; ++y) row(y, std::span(picture).subspan(index(0, y), static_cast<std::size_t>(width_)));
  return picture;
}

void Film::begin_refinement(std::uint32_t room) {
  const std::size_t pixels = lit_.size();
  samples_ = ZeroedPages<Sample>();  // gives its memory back before more is asked for
  samples_ = ZeroedPages<Sample>(pixels + room);
  if (has_alpha_) {
    clearness_ = ZeroedPages<std::int64_t>(pixels + room);
    refined_clearness_ = ZeroedPages<float>(pixels);
  }
  states_ = ZeroedPages<State>(pixels);
  refined_ = ZeroedPages<Refined>(pixels);
  first_of_mean_ = ZeroedPages<std::uint32_t>(pixels);
  pixel_of_more_ = ZeroedPages<std::uint32_t>(room);
}

void Film::begin_samples(std::span<const std::uint32_t> pixels) {
  std::ranges::copy(pixels, pixel_of_more_.begin());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    Sample& sample = samples_[lit_.size() + i];
    for (std::int64_t* const sum : {&sample.r, &sample.g, &sample.b, &sample.change}) store(*sum, std::int64_t{0});
    if (has_alpha_) store(clearness_[lit_.size() + i], std::int64_t{0});
  }
}

void Film::settle(std::uint32_t pixel) { store(states_[pixel], State::first_sample, std::memory_order_release); }

void Film::average(std::uint32_t pixel, std::uint32_t first, std::uint32_t count) {
  first_of_mean_[pixel] = first;
  count_of_mean_.store(count, std::memory_order_relaxed);
  store(states_[pixel], State::averaged, std::memory_order_release);
}

void Film::refine(std::uint32_t pixel, const PixelColor& color, float open) {
  Refined& refined = refined_[pixel];
  store(refined.r, color.light.x);
  store(refined.g, color.light.y);
  store(refined.b, color.light.z);
  if (has_alpha_) store(refined_clearness_[pixel], color.clear);
  store(refined.open, open);
  store(states_[pixel], State::refined, std::memory_order_release);
}

}  // namespace firstlight::render
