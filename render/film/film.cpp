#include "render/film/film.h"

namespace firstlight::render {

Film::Film(int width, int height)
    : width_(width),
      height_(height),
      samples_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      lit_(samples_.size()) {}

void Film::expect(std::int64_t most) {
  for (Sample& sample : samples_) sample.outstanding.store(most, std::memory_order_relaxed);
}

void Film::add(std::span<const Contribution> contributions, bool alone) {
  const auto plain = [](std::atomic<std::int64_t>& sum, std::int64_t change) {
    sum.store(FixedRgb::sum(sum.load(std::memory_order_relaxed), change), std::memory_order_relaxed);
  };
  for (const Contribution& contribution : contributions) {
    const FixedRgb& light = contribution.light;
    Sample& sample = samples_[contribution.sample];
    if (alone) {
      plain(sample.r, light.r);
      plain(sample.g, light.g);
      plain(sample.b, light.b);
      plain(sample.outstanding, contribution.outstanding);
      continue;
    }
    // Most feelers change nothing, and an atomic addition costs as much as several plain ones.
    if (light != FixedRgb()) {
      sample.r.fetch_add(light.r, std::memory_order_relaxed);
      sample.g.fetch_add(light.g, std::memory_order_relaxed);
      sample.b.fetch_add(light.b, std::memory_order_relaxed);
    }
    sample.outstanding.fetch_add(contribution.outstanding, std::memory_order_relaxed);
  }
}

Rgb Film::color(int x, int y) const {
  const Sample& sample = samples_[index(x, y)];
  return FixedRgb{sample.r.load(std::memory_order_relaxed), sample.g.load(std::memory_order_relaxed),
                  sample.b.load(std::memory_order_relaxed)}
      .to_rgb();
}

double Film::outstanding(int x, int y) const {
  return FixedRgb::to_double(samples_[index(x, y)].outstanding.load(std::memory_order_relaxed));
}

std::vector<Rgb> Film::snapshot() const {
  std::vector<Rgb> picture;
  picture.reserve(samples_.size());
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) picture.push_back(color(x, y));
  }
  return picture;
}

}  // namespace firstlight::render
