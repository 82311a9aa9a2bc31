#include "render/film/film.h"

namespace firstlight::render {

Film::Film(int width, int height)
    : width_(width), height_(height), sums_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void Film::add(std::span<const Contribution> contributions, bool alone) {
  for (const Contribution& contribution : contributions) {
    const FixedRgb& light = contribution.light;
    std::atomic<std::int64_t>* const sum = &sums_[3 * static_cast<std::size_t>(contribution.sample)];
    const std::int64_t channels[3] = {light.r, light.g, light.b};
    for (int c = 0; c < 3; ++c) {
      if (alone) {
        sum[c].store(FixedRgb::sum(sum[c].load(std::memory_order_relaxed), channels[c]), std::memory_order_relaxed);
      } else {
        sum[c].fetch_add(channels[c], std::memory_order_relaxed);
      }
    }
  }
}

Rgb Film::color(int x, int y) const {
  const std::size_t first =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
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
