// The film knows what is left: at every moment the picture differs from the finished one by at most what it says.

#include "priority/driver.h"
#include "priority/order.h"
#include "priority/schemes.h"
#include "tests/priority/small_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace firstlight::priority {
namespace {

#ifdef FIRSTLIGHT_SANITIZED
constexpr int kWidth = 23;  // everything takes many times as long
constexpr int kHeight = 19;
#else
constexpr int kWidth = 43;
constexpr int kHeight = 31;
#endif
constexpr double kStep = 0x1p-20;  // of Progress::remaining, times the pixels

std::shared_ptr<const Scheme> scheme_of(std::string_view text, const SmallScene& scene) {
  std::string error;
  const auto order = Order::parse(text, {.scene = index_of(scene.scene()), .width = kWidth, .height = kHeight}, error);
  EXPECT_TRUE(order) << text << ": " << error;
  return order ? order->scheme() : nullptr;
}

double largest_difference(const render::Rgb& a, const render::Rgb& b) {
  return std::max(
      {std::abs(double{a.x} - double{b.x}), std::abs(double{a.y} - double{b.y}), std::abs(double{a.z} - double{b.z})});
}

/// The error of a colour that comes of Film::color() giving it in single precision.
double rounding_of(const render::Rgb& color) {
  return static_cast<double>(render::max_magnitude(color)) * std::numeric_limits<float>::epsilon();
}

/// Compares the picture with the finished one at every checkpoint.
class Comparing final : public Observer {
 public:
  /// `plain`: without anti-aliasing and blur, so that what the film says is just what waiting rays can change.
  Comparing(const render::Film& film, const std::vector<render::Rgb>& finished, bool plain)
      : film_(film), finished_(finished), plain_(plain) {}

  void checkpoint(const Progress& progress) override {
    ++checkpoints;
    double difference = 0.0;
    double outstanding = 0.0;
    for (int y = 0; y < film_.height(); ++y) {
      for (int x = 0; x < film_.width(); ++x) {
        const render::Rgb& aim = finished_[static_cast<std::size_t>(y * film_.width() + x)];
        const double off = largest_difference(film_.color(x, y), aim);
        const double most = film_.outstanding(x, y);
        if (off > most + rounding_of(aim)) ++pixels_beyond;
        difference += off;
        outstanding += most;
      }
    }
    const double pixels = film_.width() * film_.height();
    EXPECT_TRUE(progress.remaining_is_bound);
    EXPECT_LE(difference / pixels, progress.remaining);
    if (!plain_) return;
    // The sum over the pixels is rounded up at each addition.
    const double rounding = (static_cast<double>(progress.traced.total()) + pixels) * kStep / pixels;
    EXPECT_GE(progress.remaining * (1.0 + 1e-9), outstanding / pixels);
    EXPECT_LE(progress.remaining, outstanding / pixels + rounding);
    EXPECT_LE(progress.remaining, last_remaining + rounding) << "what is left has become more";
    last_remaining = progress.remaining;
  }

  int checkpoints = 0;
  int pixels_beyond = 0;
  double last_remaining = std::numeric_limits<double>::infinity();

 private:
  const render::Film& film_;
  const std::vector<render::Rgb>& finished_;
  const bool plain_;
};

TEST(Remaining, BoundsTheDifferenceFromTheFinishedPictureAtEveryMoment) {
  int checkpoints = 0;
  for (SmallScene& scene : small_scenes()) {
    render::Film reference(kWidth, kHeight);
    ASSERT_TRUE(trace(scene.context(), reference, {}).complete());
    const std::vector<render::Rgb> finished = reference.snapshot();
    for (const SchemeRow& row : schemes()) {
      if (row.name == "expr") continue;  // needs a compiler
      for (const int threads : {1, 2}) {
        for (const std::size_t memory : {std::size_t{0}, kSmallestQueueMemory}) {
          SCOPED_TRACE(scene.name() + ", " + std::string(row.name) + ", " + std::to_string(threads) + " threads, " +
                       std::to_string(memory) + " bytes");
          const auto scheme = scheme_of(row.example, scene);
          render::Film film(kWidth, kHeight);
          Comparing comparing(film, finished, !scene.scene().camera.blur.shows());
          TraceOptions options;
          options.scheme = scheme.get();
          options.threads = threads;
          options.queue_memory = memory;
          options.block_size = 16;
          options.observer = &comparing;
          options.checkpoint_rays = 200;
          const TraceResult result = trace(scene.context(), film, options);
          ASSERT_TRUE(result.complete()) << result.error;
          EXPECT_GE(comparing.checkpoints, 1);
          checkpoints += comparing.checkpoints;
          EXPECT_EQ(comparing.pixels_beyond, 0);
          EXPECT_EQ(film.snapshot(), finished);
          for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) ASSERT_EQ(film.outstanding(x, y), 0.0) << x << ", " << y;
          }
          EXPECT_TRUE(result.statistics.remaining_is_bound);
          EXPECT_LE(result.statistics.remaining * kWidth * kHeight,
                    static_cast<double>(result.statistics.rays.total() + kWidth * kHeight) * kStep);
          if (HasFailure()) return;
        }
      }
    }
  }
  EXPECT_GT(checkpoints, 1000);
}

TEST(Remaining, BoundsTheDifferenceWithAntiAliasingToo) {
  int checkpoints = 0;
  for (SmallScene& scene : small_scenes()) {
    for (const int method : {1, 2}) {
      for (const char* text : {"contribution", "ray-type", "recursive"}) {
        SCOPED_TRACE(scene.name() + ", " + text + ", method " + std::to_string(method));
        const render::AntialiasSettings antialias{.method = method, .threshold = 0.1, .depth = 2, .jitter = false};
        render::Film reference(kWidth, kHeight);
        TraceOptions options;
        options.antialias = &antialias;
        ASSERT_TRUE(trace(scene.context(), reference, options).complete());
        const std::vector<render::Rgb> finished = reference.snapshot();
        const auto scheme = scheme_of(text, scene);
        render::Film film(kWidth, kHeight);
        Comparing comparing(film, finished, false);
        options.scheme = scheme.get();
        options.threads = 2;
        options.observer = &comparing;
        options.checkpoint_rays = 500;
        const TraceResult result = trace(scene.context(), film, options);
        ASSERT_TRUE(result.complete()) << result.error;
        EXPECT_EQ(comparing.pixels_beyond, 0);
        EXPECT_EQ(film.snapshot(), finished);
        checkpoints += comparing.checkpoints;
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(checkpoints, 50);
}

TEST(Remaining, TracingEndsWhenTheErrorIsSmallEnough) {
  SmallScene scene = hall_of_mirrors();
  render::Film reference(kWidth, kHeight);
  const TraceResult whole = trace(scene.context(), reference, {});
  ASSERT_TRUE(whole.complete());
  const auto scheme = scheme_of("contribution", scene);
  for (const double error : {0.5, 0.05}) {
    render::Film film(kWidth, kHeight);
    TraceOptions options;
    options.scheme = scheme.get();
    options.stop_at_error = error;
    const TraceResult result = trace(scene.context(), film, options);
    if (result.complete()) continue;  // a small picture may be done before anybody looks
    EXPECT_EQ(result.end, End::error_reached);
    EXPECT_LE(result.statistics.remaining, error);
    double difference = 0.0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) difference += largest_difference(film.color(x, y), reference.color(x, y));
    }
    EXPECT_LE(difference / (kWidth * kHeight), error);
  }
}

}  // namespace
}  // namespace firstlight::priority
