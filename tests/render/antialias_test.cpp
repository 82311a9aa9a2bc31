// Rounds of samples end in the picture that POV-Ray's rules, followed pixel by pixel, give.

#include "render/film/antialias.h"

#include "render/film/contrast.h"
#include "render/film/jitter.h"
#include "tests/render/antialias_painting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace firstlight::render {
namespace {

AntialiasSettings settings_of(int method, double threshold, int depth, bool jitter = false) {
  AntialiasSettings settings;
  settings.method = method;
  settings.threshold = threshold;
  settings.depth = depth;
  settings.jitter = jitter;
  return settings;
}

/// Method 1 as it is told to a person: along the rows of each block, each pixel against what its neighbours are by
/// then.
class PixelByPixel {
 public:
  PixelByPixel(const AntialiasSettings& settings, const Painting& painting, int width, int height)
      : settings_(settings), painting_(painting), contrast_(settings), jitter_(settings, settings.depth) {
    picture.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const int size = settings.block_size;
    for (int top = 0; top < height; top += size) {
      for (int left = 0; left < width; left += size) {
        begin_block(left, top);
        for (int y = top; y < std::min(top + size, height); ++y) {
          for (int x = left; x < std::min(left + size, width); ++x) look_at(x, y);
        }
        for (int y = top; y < std::min(top + size, height); ++y) {
          for (int x = left; x < std::min(left + size, width); ++x) {
            picture[static_cast<std::size_t>(y * width + x)] = pixel(x, y).color;
          }
        }
      }
    }
  }

  std::vector<Rgb> picture;

 private:
  struct Pixel {
    Rgb color;
    bool done = false;
    bool known = false;
  };

  void begin_block(int left, int top) {
    left_ = left;
    top_ = top;
    pixels_.assign(static_cast<std::size_t>((settings_.block_size + 1) * (settings_.block_size + 1)), {});
  }
  Pixel& pixel(int x, int y) {
    Pixel& found = pixels_[static_cast<std::size_t>((y - top_ + 1) * (settings_.block_size + 1) + (x - left_ + 1))];
    if (!found.known) {
      const bool outside = x < left_ || y < top_;  // a neighbour from another block never gets more samples
      found = {as_on_film(painting_(x + 0.5, y + 0.5)), outside, true};
    }
    return found;
  }
  void supersample(int x, int y) {
    Pixel& here = pixel(x, y);
    if (here.done) return;
    here.done = true;
    const double step = 1.0 / settings_.depth;
    const double range = 0.5 - step * 0.5;
    for (double dy = -range; dy <= range + 1e-10; dy += step) {
      for (double dx = -range; dx <= range + 1e-10; dx += step) {
        const PicturePoint place = jitter_.move({x + dx, y + dy});
        here.color += as_on_film(painting_(place.x + 0.5, place.y + 0.5));
      }
    }
    const double count = settings_.depth * settings_.depth + 1;
    for (int i = 0; i < 3; ++i) here.color[i] = static_cast<float>(here.color[i] / count);
  }
  void look_at(int x, int y) {
    const auto encoded = [&](int px, int py) { return contrast_.encode(pixel(px, py).color); };
    const bool left = contrast_.between(encoded(x - 1, y), encoded(x, y));
    const bool above = contrast_.between(encoded(x, y - 1), encoded(x, y));
    if (left) supersample(x - 1, y);
    if (above) supersample(x, y - 1);
    if (left || above) supersample(x, y);
  }

  AntialiasSettings settings_;
  const Painting& painting_;
  Contrast contrast_;
  Jitter jitter_;
  int left_ = 0;
  int top_ = 0;
  std::vector<Pixel> pixels_;
};

/// Method 2, quarter by quarter.
class QuarterByQuarter {
 public:
  QuarterByQuarter(const AntialiasSettings& settings, const Painting& painting)
      : painting_(painting), contrast_(settings), jitter_(settings, (1 << settings.depth) + 1) {}

  Rgb pixel(int x, int y, int depth) { return square(x - 0.5, y - 0.5, 1.0, corners_of(x, y), depth - 1); }

 private:
  using Corners = std::array<Rgb, 4>;
  Rgb at(double x, double y) { return as_on_film(painting_(x + 0.5, y + 0.5)); }
  Rgb jittered(double x, double y) {
    const PicturePoint place = jitter_.move({x, y});
    return at(place.x, place.y);
  }
  Corners corners_of(int x, int y) {
    return {at(x - 0.5, y - 0.5), at(x + 0.5, y - 0.5), at(x - 0.5, y + 0.5), at(x + 0.5, y + 0.5)};
  }
  Rgb square(double x, double y, double side, const Corners& c, int levels) {
    bool differ = false;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < i; ++k) differ |= contrast_.between(contrast_.encode(c[i]), contrast_.encode(c[k]));
    }
    if (!differ || levels == 0) return (c[0] + c[1] + c[2] + c[3]) / 4.0f;
    const double half = side / 2;
    const Rgb top = jittered(x + half, y);
    const Rgb left = jittered(x, y + half);
    const Rgb middle = jittered(x + half, y + half);
    const Rgb right = jittered(x + side, y + half);
    const Rgb bottom = jittered(x + half, y + side);
    return (square(x, y, half, {c[0], top, left, middle}, levels - 1) +
            square(x + half, y, half, {top, c[1], middle, right}, levels - 1) +
            square(x, y + half, half, {left, middle, c[2], bottom}, levels - 1) +
            square(x + half, y + half, half, {middle, right, bottom, c[3]}, levels - 1)) /
           4.0f;
  }

  const Painting& painting_;
  Contrast contrast_;
  Jitter jitter_;
};

std::size_t sum_of(const std::vector<std::size_t>& rounds) {
  return std::accumulate(rounds.begin(), rounds.end(), std::size_t{0});
}

TEST(Antialias, MethodOneEndsAsIfDecidedPixelByPixel) {
  constexpr int kWidth = 71;
  constexpr int kHeight = 45;
  for (unsigned seed = 0; seed < 12; ++seed) {
    AntialiasSettings settings = settings_of(1, seed % 3 * 0.2 + 0.02, 1 + static_cast<int>(seed) % 4, seed % 2 == 1);
    settings.block_size = seed % 4 == 3 ? 7 : 32;
    const Painting painting = seed < 9 ? random_shapes(seed, kWidth, kHeight) : noise(seed);
    const Development development(settings, painting, kWidth, kHeight);
    const PixelByPixel expected(settings, painting, kWidth, kHeight);
    EXPECT_EQ(development.film.snapshot(), expected.picture) << "seed " << seed;
    EXPECT_LE(development.rounds.size(), 8u) << "seed " << seed;
  }
}

TEST(Antialias, MethodTwoEndsAsIfQuarteredOneByOne) {
  constexpr int kWidth = 37;
  constexpr int kHeight = 41;
  for (unsigned seed = 0; seed < 12; ++seed) {
    const AntialiasSettings settings =
        settings_of(2, seed % 3 * 0.2 + 0.02, 1 + static_cast<int>(seed) % 4, seed % 2 == 1);
    const Painting painting = seed < 9 ? random_shapes(seed, kWidth, kHeight) : noise(seed);
    const Development development(settings, painting, kWidth, kHeight);
    QuarterByQuarter expected(settings, painting);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Rgb difference = development.film.color(x, y) - expected.pixel(x, y, settings.depth);
        ASSERT_LT(max_magnitude(difference), 1e-5f) << "seed " << seed << " at " << x << ", " << y;
      }
    }
    EXPECT_LE(development.rounds.size(), static_cast<std::size_t>(settings.depth)) << "seed " << seed;
  }
}

TEST(Antialias, NoPixelIsFurtherFromItsEndThanItsBound) {
  constexpr int kWidth = 50;
  constexpr int kHeight = 40;
  for (const int method : {1, 2}) {
    const AntialiasSettings settings = settings_of(method, 0.1, 3);
    const Painting painting = random_shapes(3, kWidth, kHeight);
    const std::vector<Rgb> end = Development(settings, painting, kWidth, kHeight).film.snapshot();
    double largest = 0.0;
    const Development again(settings, painting, kWidth, kHeight, [&](const Film& film) {
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          const Rgb error = film.color(x, y) - end[static_cast<std::size_t>(y * kWidth + x)];
          EXPECT_LE(max_magnitude(error), film.outstanding(x, y) + 1e-6);
          largest = std::max(largest, static_cast<double>(max_magnitude(error)));
        }
      }
    });
    EXPECT_GT(largest, 0.1);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) EXPECT_EQ(again.film.outstanding(x, y), 0.0);
    }
  }
}

TEST(Antialias, AnEvenPictureNeedsNoMoreThanItsEdge) {
  const Painting even = [](double, double) { return Rgb(0.25f, 0.5f, 0.75f); };
  EXPECT_EQ(Development(settings_of(1, 0.3, 3), even, 20, 10).rounds, (std::vector<std::size_t>{20 + 10}));
  EXPECT_EQ(Development(settings_of(2, 0.3, 3), even, 20, 10).rounds, (std::vector<std::size_t>{20 + 10 + 1}));
}

TEST(Antialias, LittleIsTracedInVain) {
  constexpr int kWidth = 160;
  constexpr int kHeight = 120;
  const AntialiasSettings settings = settings_of(1, 0.3, 3);
  const Development development(settings, random_shapes(5, kWidth, kHeight), kWidth, kHeight);
  std::size_t refined = 0;
  for (std::uint32_t pixel = 0; pixel < development.film.pixels(); ++pixel) {
    refined += development.film.refined_color(pixel) != Rgb(0.0f) ? 1 : 0;
  }
  ASSERT_GT(refined, 100u);
  EXPECT_LE(sum_of(development.rounds) - kWidth - kHeight, refined * 9 * 21 / 20);
}

TEST(Antialias, WhatTheFilmHasNoRoomForComesInPortions) {
  constexpr int kSize = 60;
  const Painting painting = noise(1);
  const AntialiasSettings settings = settings_of(1, 0.0, 9);
  const Development development(settings, painting, kSize, kSize);
  const std::size_t room = development.film.room();
  EXPECT_TRUE(std::ranges::all_of(development.rounds, [room](std::size_t samples) { return samples <= room; }));
  EXPECT_EQ(sum_of(development.rounds), 2u * kSize + 81u * kSize * kSize);
  EXPECT_EQ(development.film.snapshot(), PixelByPixel(settings, painting, kSize, kSize).picture);
}

TEST(Antialias, HalvingToTheEndTracesEachPlaceOnce) {
  constexpr int kSize = 24;
  const Development development(settings_of(2, 0.0, 4), noise(1), kSize, kSize);
  // A grid of 8 cells a pixel, its corners included.
  EXPECT_EQ(sum_of(development.rounds), (8u * kSize + 1) * (8u * kSize + 1) - kSize * kSize);
  EXPECT_EQ(development.rounds.size(), 4u);
}

TEST(Antialias, SmallestPicturesWork) {
  const Painting painting = noise(9);
  for (const int method : {1, 2}) {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 5), std::pair(5, 1), std::pair(3, 3)}) {
      const Development development(settings_of(method, 0.1, 2, true), painting, width, height);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) EXPECT_EQ(development.film.outstanding(x, y), 0.0);
      }
    }
  }
}

TEST(Contrast, IsSeenInTheAntiAliasingGamma) {
  AntialiasSettings settings;
  EXPECT_FLOAT_EQ(Contrast(settings).encode(Rgb(0.25f)).light.x, std::pow(0.25f, 0.4f));
  EXPECT_EQ(Contrast(settings).encode(Rgb(-1.0f)).light.x, 0.0f);
  settings.gamma = 1.0;
  EXPECT_EQ(Contrast(settings).encode(Rgb(-1.0f, 0.25f, 4.0f)), Rgb(-1.0f, 0.25f, 4.0f));
}

TEST(Contrast, TakesTheScenesNumbersForWhatTheyMean) {
  AntialiasSettings settings;
  settings.working_exponent = 2.5;
  EXPECT_EQ(Contrast(settings).encode(Rgb(0.25f)).light.x, 0.25f);
  settings.working_exponent = 2.2;
  EXPECT_NEAR(Contrast(settings).encode(Rgb(0.25f)).light.x, std::pow(0.25, 2.2 / 2.5), 1e-6);
  settings.working_srgb = true;
  EXPECT_NEAR(Contrast(settings).encode(Rgb(0.5f)).light.x, std::pow(0.214041, 0.4), 1e-5);
}

TEST(Contrast, AddsTheChannelsUnclipped) {
  AntialiasSettings settings;
  settings.gamma = 1.0;
  settings.threshold = 0.5;
  const Contrast contrast(settings);
  EXPECT_TRUE(contrast.between(Rgb(0.0f), Rgb(0.25f, 0.25f, 0.0f)));
  EXPECT_FALSE(contrast.between(Rgb(0.0f), Rgb(0.25f, 0.125f, 0.0f)));
  EXPECT_TRUE(contrast.between(Rgb(3.0f), Rgb(3.5f, 3.0f, 3.0f)));
}

TEST(Jitter, StaysWithinItsCellAndDependsOnThePlaceAlone) {
  AntialiasSettings settings;
  const Jitter jitter(settings, 3);
  double sum = 0.0;
  double farthest = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const PicturePoint place{i * 0.37 - 0.5, i * 0.11 - 0.5};
    const PicturePoint moved = jitter.move(place);
    EXPECT_EQ(jitter.move(place).x, moved.x);
    farthest = std::max({farthest, std::abs(moved.x - place.x), std::abs(moved.y - place.y)});
    sum += moved.x - place.x;
  }
  EXPECT_LE(farthest, 0.5 / 3 + 1e-9);
  EXPECT_GT(farthest, 0.45 / 3);
  EXPECT_LT(std::abs(sum / 2000), 0.02);
  settings.jitter = false;
  EXPECT_EQ(Jitter(settings, 3).move({7.25, 3.5}).x, 7.25);
}

}  // namespace
}  // namespace firstlight::render
