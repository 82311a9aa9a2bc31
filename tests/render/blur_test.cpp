#include "render/film/blur.h"

#include "render/film/antialias.h"
#include "render/film/place_sampler.h"
#include "tests/render/antialias_painting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace firstlight::render {
namespace {

BlurSettings settings_of(int samples, double variance = 1e-3, int min_samples = 0, bool is_round = true) {
  return {
      .samples = samples, .min_samples = min_samples, .confidence = 0.9, .variance = variance, .is_round = is_round};
}

std::vector<int> stops_of(const BlurSettings& settings) {
  const BlurRule rule(settings);
  std::vector<int> stops;
  for (int count = 0; count < settings.samples;) stops.push_back(count = rule.next_stop(count));
  return stops;
}

TEST(BlurRule, AsksInThePortionsOfItsLens) {
  EXPECT_EQ(stops_of(settings_of(1)), (std::vector{1}));
  EXPECT_EQ(stops_of(settings_of(6)), (std::vector{4, 6}));
  EXPECT_EQ(stops_of(settings_of(7)), (std::vector{7}));
  EXPECT_EQ(stops_of(settings_of(18)), (std::vector{7, 11, 15, 18}));
  EXPECT_EQ(stops_of(settings_of(22)), (std::vector{7, 13, 19, 22}));
  EXPECT_EQ(stops_of(settings_of(45)), (std::vector{7, 13, 19, 23, 27, 31, 35, 37, 41, 45}));
  EXPECT_EQ(stops_of(settings_of(10, 1e-3, 0, /*is_round=*/false)), (std::vector{4, 8, 10}));
}

TEST(BlurRule, PlainPlacesHaveEnoughAtOnceAndOthersNot) {
  const BlurRule rule(settings_of(40));
  PlaceSums plain;
  PlaceSums mixed;
  for (int i = 0; i < 7; ++i) {
    plain.add(Rgb(0.5f));
    mixed.add(Rgb(i % 2 == 0 ? 0.0f : 1.0f));
  }
  EXPECT_TRUE(rule.is_enough(plain));
  EXPECT_FALSE(rule.is_enough(mixed));
  EXPECT_FALSE(BlurRule(settings_of(40, 1e-3, /*min_samples=*/8)).is_enough(plain));
}

/// The light of a sample of a place: its own for each number.
Rgb light_of(const Painting& painting, double x, double y, std::uint32_t number) {
  return painting(x + 0.3 * std::sin(number * 1.7), y + 0.3 * std::cos(number * 2.3));
}

/// The colour that a place becomes, sample after sample.
Rgb place_color(const Painting& painting, const BlurSettings& settings, double x, double y) {
  const BlurRule rule(settings);
  PlaceSums sums;
  do {
    for (const int stop = rule.next_stop(sums.count); sums.count < stop;) {
      sums.add(as_on_film(light_of(painting, x, y, static_cast<std::uint32_t>(sums.count))));
    }
  } while (!rule.is_enough(sums));
  return sums.mean().light;
}

/// A blurred picture from its first samples to its end; returns how many rounds it took.
int develop(Film& film, const BlurSettings& settings, const AntialiasSettings* antialias, const Painting& painting) {
  int rounds = 0;
  const std::int64_t most = FixedRgb::from(Rgb(2.0f)).r;
  film.expect(most);
  PlaceSampler places(film, settings);
  const double offset = antialias != nullptr ? base_offset(*antialias) : 0.5;
  PixelBlur blur(places, offset, antialias == nullptr);
  std::optional<Antialiasing> antialiasing;
  if (antialias != nullptr) antialiasing.emplace(*antialias, film, places);
  std::vector<SamplePoint> first;
  for (std::uint32_t pixel = 0; pixel < film.pixels(); ++pixel) {
    const auto w = static_cast<std::uint32_t>(film.width());
    first.push_back({pixel % w + offset, pixel / w + offset, pixel});
  }
  const auto trace = [&](std::span<const SamplePoint> points) {
    for (const SamplePoint& point : points) {
      const Contribution light{point.sample, FixedRgb::from(light_of(painting, point.x, point.y, point.number)), -most};
      film.add({&light, 1});
    }
    ++rounds;
  };
  trace(first);
  for (auto points = blur.next(); !points.empty(); points = blur.next()) trace(points);
  if (!antialiasing) return rounds;
  for (auto points = antialiasing->next(); !points.empty(); points = antialiasing->next()) trace(points);
  return rounds;
}

TEST(PlaceSampler, FindsWhatAPlaceBecomesSampleAfterSample) {
  const Painting painting = random_shapes(5, 30, 20);
  for (const int samples : {1, 4, 7, 10, 25, 50}) {
    const BlurSettings settings = settings_of(samples);
    Film film(30, 20);
    develop(film, settings, nullptr, painting);
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 30; ++x) {
        ASSERT_EQ(film.color(x, y), place_color(painting, settings, x + 0.5, y + 0.5))
            << x << ' ' << y << ' ' << samples;
        ASSERT_EQ(film.outstanding(x, y), 0.0);
      }
    }
  }
}

TEST(PlaceSampler, APictureThatIsLargerThanItsRoomIsTheSame) {
  const Painting painting = noise(3);
  const BlurSettings settings = settings_of(9, 1e-4);
  Film film(400, 300);  // 7 samples of each pixel are more than 2^18
  EXPECT_GT(develop(film, settings, nullptr, painting), 4);
  for (int y = 0; y < 300; y += 7) {
    for (int x = 0; x < 400; x += 7) ASSERT_EQ(film.color(x, y), place_color(painting, settings, x + 0.5, y + 0.5));
  }
}

TEST(PlaceSampler, AntialiasingTakesMeansOfPlaces) {
  const Painting painting = random_shapes(8, 24, 18);
  const BlurSettings settings = settings_of(12);
  for (const int method : {1, 2}) {
    AntialiasSettings antialias;
    antialias.method = method;
    antialias.threshold = 0.05;
    antialias.depth = 2;
    Film film(24, 18);
    develop(film, settings, &antialias, painting);
    // The same picture, of places that need one sample each.
    const Painting of_places = [&](double x, double y) { return place_color(painting, settings, x, y); };
    const Development plain(antialias, of_places, 24, 18);
    double worst = 0.0;
    for (int y = 0; y < 18; ++y) {
      for (int x = 0; x < 24; ++x) {
        const Rgb d = film.color(x, y) - plain.film.color(x, y);
        worst = std::max(worst, static_cast<double>(max_magnitude(d)));
        EXPECT_EQ(film.outstanding(x, y), 0.0);
      }
    }
    EXPECT_LT(worst, 1e-6) << method;
  }
}

}  // namespace
}  // namespace firstlight::render
