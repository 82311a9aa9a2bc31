#include "render/film/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <thread>
#include <vector>

namespace firstlight::render {
namespace {

std::vector<Contribution> random_light(std::uint32_t samples, std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> value(-3.0f, 40.0f);
  std::vector<Contribution> light(count);
  for (Contribution& c : light) {
    c = {static_cast<std::uint32_t>(random() % samples), FixedRgb::from({value(random), value(random), value(random)})};
  }
  return light;
}

TEST(Film, SumsDoNotDependOnTheOrder) {
  std::vector<Contribution> light = random_light(6, 5000);
  Film forwards(3, 2);
  forwards.add(light);
  std::reverse(light.begin(), light.end());
  Film backwards(3, 2);
  backwards.add(light);
  EXPECT_EQ(forwards.snapshot(), backwards.snapshot());
}

TEST(Film, ThreadsAddToTheSameSums) {
  constexpr int kWidth = 256;
  constexpr int kHeight = 128;
  const std::vector<Contribution> light = random_light(kWidth * kHeight, 100'000);
  Film alone(kWidth, kHeight);
  alone.add(light);
  for (const int threads : {2, 5, 100}) {
    Film shared(kWidth, kHeight);
    shared.deal_out(threads);
    const std::size_t half = light.size() / 2;
    std::thread other([&] { shared.add(std::span(light).first(half)); });
    shared.add(std::span(light).subspan(half));
    other.join();
    EXPECT_EQ(alone.snapshot(), shared.snapshot()) << threads;
  }
}

TEST(Film, IsCompleteWhenNothingIsOutstandingAndAllIsLit) {
  Film film(2, 1);
  film.expect(100);
  EXPECT_FALSE(film.is_complete());
  const std::vector<Contribution> light = {{0, FixedRgb::from({1.0f, 2.0f, 3.0f}), -100},
                                           {1, FixedRgb::from({4.0f, 5.0f, 6.0f}), -100}};
  film.mark_lit(0);
  film.add(std::span(light).first(1));
  film.mark_lit(1);
  EXPECT_FALSE(film.is_complete()) << "light may still come";
  film.add(std::span(light).subspan(1));
  EXPECT_TRUE(film.is_complete());
  std::vector<Rgb> row(2);
  film.row(0, row);
  EXPECT_EQ(row, film.snapshot());
}

TEST(Film, DealsBandsOfRowsOutAmongThreads) {
  constexpr int kWidth = 300;
  constexpr int kHeight = 200;
  for (const int threads : {1, 2, 3, 12}) {
    Film film(kWidth, kHeight);
    film.deal_out(threads);
    std::vector<int> dealt(static_cast<std::size_t>(threads));
    int changes = 0;
    for (std::uint32_t sample = 0; sample < film.pixels(); ++sample) {
      ASSERT_LT(film.owner_of(sample), dealt.size());
      ++dealt[film.owner_of(sample)];
      changes += sample > 0 && film.owner_of(sample) != film.owner_of(sample - 1) ? 1 : 0;
    }
    EXPECT_GT(*std::ranges::min_element(dealt), static_cast<int>(film.pixels()) / threads / 2) << threads;
    EXPECT_LE(changes, kHeight / 16) << threads;
  }
}

TEST(Film, TakingBackWhatWasAddedLeavesNothing) {
  Film film(1, 1);
  const Rgb light(0.1f, 1.0f / 3.0f, 1e-7f);
  film.add(std::vector<Contribution>{{0, FixedRgb::from(light)}, {0, FixedRgb::from(-light)}});
  EXPECT_EQ(film.color(0, 0), Rgb(0.0f));
}

TEST(Film, SampleNumbersRunAlongRowsFromTheTop) {
  Film film(3, 2);
  film.add(std::vector<Contribution>{{4, FixedRgb::from(Rgb(0.5f))}});
  EXPECT_EQ(film.color(1, 1), Rgb(0.5f));
  EXPECT_EQ(film.color(1, 0), Rgb(0.0f));
}

TEST(Film, NotANumberAddsNothing) {
  Film film(1, 1);
  film.add(std::vector<Contribution>{{0, FixedRgb::from({std::numeric_limits<float>::quiet_NaN(), 0.25f, 0.5f})}});
  EXPECT_EQ(film.color(0, 0), Rgb(0.0f, 0.25f, 0.5f));
}

TEST(Film, EnormousLightIsCutNotWrapped) {
  Film film(1, 1);
  film.add(std::vector<Contribution>{{0, FixedRgb::from({std::numeric_limits<float>::infinity(), -1e30f, 1.0f})}});
  EXPECT_EQ(film.color(0, 0), Rgb(16777216.0f, -16777216.0f, 1.0f));
}

TEST(Film, WithAntiAliasingAPixelIsCompleteOnlyWhenSaidSo) {
  Film film(2, 1);
  const std::int64_t most = FixedRgb::from(Rgb(3.0f)).r;
  film.expect(most, 0);
  film.begin_refinement(8);
  film.add(std::vector<Contribution>{{0, FixedRgb::from(Rgb(1.0f)), -most}, {1, FixedRgb::from(Rgb(0.5f)), -most}});
  EXPECT_EQ(film.outstanding(0, 0), 2.0);  // between 0 and 3
  EXPECT_EQ(film.outstanding(1, 0), 2.5);
  film.settle(0);
  film.refine(1, Rgb(0.75f), 0.25f);
  EXPECT_EQ(film.outstanding(0, 0), 0.0);
  EXPECT_EQ(film.outstanding(1, 0), 0.75);
  EXPECT_EQ(film.color(0, 0), Rgb(1.0f));
  EXPECT_EQ(film.color(1, 0), Rgb(0.75f));
  EXPECT_EQ(film.sample_color(1), Rgb(0.5f));
}

TEST(Film, APixelInRefinementShowsTheMeanOfWhatIsComplete) {
  Film film(1, 1);
  const std::int64_t most = FixedRgb::from(Rgb(2.0f)).r;
  film.expect(most, 0);
  film.begin_refinement(2);
  film.add(std::vector<Contribution>{{0, FixedRgb::from(Rgb(1.0f)), -most}});
  film.begin_samples(std::vector<std::uint32_t>{0, 0});
  film.average(0, 1, 2);
  EXPECT_EQ(film.color(0, 0), Rgb(1.0f));
  EXPECT_EQ(film.outstanding(0, 0), 1.0);
  film.add(std::vector<Contribution>{{1, FixedRgb::from(Rgb(0.5f)), -most}});
  EXPECT_EQ(film.color(0, 0), Rgb(0.75f));
  // The third sample ends between 0 and 2, and so the mean between 1.5 / 3 and 3.5 / 3.
  EXPECT_GE(film.outstanding(0, 0), 3.5 / 3 - 0.75);
  EXPECT_LE(film.outstanding(0, 0), 1.25);
  // Half traced, it is not shown.
  film.add(std::vector<Contribution>{{2, FixedRgb::from(Rgb(0.25f)), -most / 2}});
  EXPECT_EQ(film.color(0, 0), Rgb(0.75f));
  film.add(std::vector<Contribution>{{2, FixedRgb::from(Rgb(1.25f)), -most / 2}});
  EXPECT_EQ(film.color(0, 0), Rgb(1.0f));
  EXPECT_EQ(film.outstanding(0, 0), 0.0);
}

TEST(Film, AddsUpWhatShowsThroughWhereThatIsAskedFor) {
  const std::int64_t half = FixedRgb::to_fixed(0.5f);
  const std::vector<Clearness> shares{{0, half}, {1, half / 2}, {0, half / 2}};
  Film plain(2, 1);
  plain.add(shares);
  EXPECT_EQ(plain.pixel(0, 0), PixelColor());
  Film film(2, 1, /*has_alpha=*/true);
  film.begin_refinement(2);
  film.add(shares);
  film.settle(0);
  EXPECT_EQ(film.pixel(0, 0), PixelColor(Rgb(0.0f), 0.75f));
  EXPECT_EQ(film.sample(1).clear, 0.25f);
  film.refine(1, PixelColor(Rgb(1.0f), 0.125f), 0.0f);
  EXPECT_EQ(film.pixel(1, 0), PixelColor(Rgb(1.0f), 0.125f));
  film.begin_samples(std::vector<std::uint32_t>{0, 0});
  film.add(std::vector<Clearness>{{2, half}, {3, half}});
  EXPECT_EQ(film.sample(3).clear, 0.5f);
  film.begin_samples(std::vector<std::uint32_t>{0, 0});
  EXPECT_EQ(film.sample(3).clear, 0.0f) << "they begin anew";
}

TEST(Film, SamplesBeyondThePixelsBeginAnew) {
  Film film(2, 1);
  film.begin_refinement(2);
  film.begin_samples(std::vector<std::uint32_t>{1, 0});
  film.add(std::vector<Contribution>{{2, FixedRgb::from(Rgb(1.0f))}, {3, FixedRgb::from(Rgb(2.0f))}});
  film.mark_lit(3);
  EXPECT_EQ(film.sample_color(3), Rgb(2.0f));
  EXPECT_EQ(film.pixel_of(2), 1u);
  EXPECT_EQ(film.pixel_of(3), 0u);
  EXPECT_EQ(film.pixel_of(1), 1u);
  film.begin_samples(std::vector<std::uint32_t>{1, 1});
  EXPECT_EQ(film.sample_color(2), Rgb(0.0f));
  EXPECT_EQ(film.pixel_of(3), 1u);
  EXPECT_EQ(film.snapshot(), (std::vector<Rgb>(2, Rgb(0.0f))));
}

}  // namespace
}  // namespace firstlight::render
