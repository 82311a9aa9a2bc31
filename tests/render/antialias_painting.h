#pragma once

#include "render/film/antialias.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <vector>

namespace firstlight::render {

/// The light of a picture, by picture coordinates: what tracing would bring.
using Painting = std::function<Rgb(double, double)>;

/// The light as it comes to the film, in steps of FixedRgb.
inline Rgb as_on_film(const Rgb& light) { return FixedRgb::from(light).to_rgb(); }

/// Shapes with sharp edges at random places, and a smooth ground.
inline Painting random_shapes(unsigned seed, int width, int height) {
  struct Disc {
    double x, y, radius;
    Rgb color;
  };
  std::mt19937 random(seed);
  const auto number = [&random](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  std::vector<Disc> discs;
  for (int i = 0; i < 12; ++i) {
    discs.push_back({number(0, width), number(0, height), number(1, height / 3.0),
                     Rgb(static_cast<float>(number(0, 1.5)), static_cast<float>(number(0, 1)), 0.2f)});
  }
  return [discs, width](double x, double y) {
    Rgb color(static_cast<float>(0.3 + 0.2 * std::sin(x / 9)), 0.1f, static_cast<float>(std::abs(x) / width));
    for (const Disc& disc : discs) {
      if (std::hypot(x - disc.x, y - disc.y) < disc.radius) color = disc.color;
    }
    return color;
  };
}

/// A colour of its own at each place.
inline Painting noise(unsigned seed) {
  return [seed](double x, double y) {
    std::minstd_rand random(seed +
                            static_cast<unsigned>(std::llround(x * 4096) * 7919 + std::llround(y * 4096) * 104729));
    const auto channel = [&random] { return static_cast<float>(random() % 1000) / 1000.0f; };
    const float r = channel();
    const float g = channel();
    return Rgb(r, g, channel());
  };
}

/// Puts all light of samples on the film.
inline void expose(Film& film, const Painting& painting, std::span<const SamplePoint> points, std::int64_t expected) {
  for (const SamplePoint& point : points) {
    const Contribution light{point.sample, FixedRgb::from(painting(point.x, point.y)), -expected};
    film.add(std::span(&light, 1));
    film.mark_lit(point.sample);
  }
}

/// A picture from its first samples to its end.
struct Development {
  Film film;
  std::vector<std::size_t> rounds;  ///< samples of each

  /// `look` is called with the film when a third of a round is complete, and another, and all of it.
  Development(const AntialiasSettings& settings, const Painting& painting, int width, int height,
              const std::function<void(const Film&)>& look = {})
      : film(width, height) {
    const std::int64_t most = FixedRgb::from(Rgb(2.0f)).r;
    film.expect(most);
    PlaceSampler places(film, std::nullopt);
    Antialiasing antialiasing(settings, film, places);
    const double offset = base_offset(settings);
    std::vector<SamplePoint> first;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        first.push_back({x + offset, y + offset, static_cast<std::uint32_t>(y * width + x)});
      }
    }
    std::span<const SamplePoint> points = first;
    while (!points.empty()) {
      for (std::size_t third = 0; third < 3; ++third) {
        const std::size_t begin = points.size() * third / 3;
        expose(film, painting, points.subspan(begin, points.size() * (third + 1) / 3 - begin), most);
        if (look) look(film);
      }
      points = antialiasing.next();
      if (!points.empty()) rounds.push_back(points.size());
    }
  }
};

}  // namespace firstlight::render
