#include "render/film/film.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

constexpr double kStep = 1.0 / 68719476736.0;  // 2^-36
constexpr double kLimit = 16777216.0;          // 2^24

std::int64_t to_fixed(float value) {
  const double limited = std::min(std::max(static_cast<double>(value), -kLimit), kLimit);
  return std::isnan(value) ? 0 : std::llrint(limited * (1.0 / kStep));
}

// Wraps instead of overflowing, so that even absurd scenes end in the same picture in any order.
std::int64_t wrapping_sum(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}

}  // namespace

FixedRgb FixedRgb::from(const Rgb& color) { return {to_fixed(color.x), to_fixed(color.y), to_fixed(color.z)}; }

Rgb FixedRgb::to_rgb() const {
  return {static_cast<float>(static_cast<double>(r) * kStep), static_cast<float>(static_cast<double>(g) * kStep),
          static_cast<float>(static_cast<double>(b) * kStep)};
}

FixedRgb& FixedRgb::operator+=(const FixedRgb& other) {
  r = wrapping_sum(r, other.r);
  g = wrapping_sum(g, other.g);
  b = wrapping_sum(b, other.b);
  return *this;
}

Film::Film(int width, int height)
    : width_(width), height_(height), sums_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void Film::add(std::span<const Contribution> contributions, bool alone) {
  for (const Contribution& contribution : contributions) {
    const FixedRgb light = FixedRgb::from(contribution.light);
    std::atomic<std::int64_t>* const sum = &sums_[3 * static_cast<std::size_t>(contribution.sample)];
    const std::int64_t channels[3] = {light.r, light.g, light.b};
    for (int c = 0; c < 3; ++c) {
      if (alone) {
        sum[c].store(wrapping_sum(sum[c].load(std::memory_order_relaxed), channels[c]), std::memory_order_relaxed);
      } else {
        sum[c].fetch_add(channels[c], std::memory_order_relaxed);
      }
    }
  }
}

Rgb Film::color(int x, int y) const {
  const std::size_t first = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
  return FixedRgb{sums_[first].load(std::memory_order_relaxed), sums_[first + 1].load(std::memory_order_relaxed),
                  sums_[first + 2].load(std::memory_order_relaxed)}
      .to_rgb();
}

std::vector<Rgb> Film::snapshot() const {
  std::vector<Rgb> picture;
  picture.reserve(sums_.size() / 3);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) picture.push_back(color(x, y));
  }
  return picture;
}

}  // namespace firstlight::render
