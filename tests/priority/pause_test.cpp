// Pauses: nothing moves, nothing is lost, and whatever happens meanwhile, there is a way out.

#include "priority/driver.h"
#include "priority/order.h"
#include "priority/steering.h"
#include "tests/priority/mirror_room.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <new>
#include <string>
#include <thread>
#include <vector>

namespace firstlight::priority {
namespace {

using std::chrono::milliseconds;

#ifdef FIRSTLIGHT_SANITIZED
constexpr int kWidth = 40;  // everything takes many times as long
constexpr int kHeight = 30;
#else
constexpr int kWidth = 120;
constexpr int kHeight = 90;
#endif

/// A picture that is rendered in a thread of its own while the test steers.
class Pause : public testing::TestWithParam<int> {
 protected:
  void begin(std::string_view text, Observer* observer = nullptr, const std::atomic<bool>* stop = nullptr) {
    std::string error;
    auto order = Order::parse(text, {.scene = index_of(room_.scene()), .width = kWidth, .height = kHeight}, error);
    ASSERT_TRUE(order) << error;
    steering_ = std::make_unique<Steering>(std::move(*order));
    steering_->pause();  // so that nothing is over before the test looks
    options_.threads = GetParam();
    options_.steering = steering_.get();
    options_.observer = observer;
    options_.stop = stop;
    done_ = false;
    tracer_ = std::thread([this] {
      result_ = trace(room_.context(), film_, options_);
      done_ = true;
    });
  }
  /// Waits for the end of the tracing. False, and the pause is over, when it does not come.
  bool ends() {
    for (int i = 0; i < 1000 && !done_; ++i) std::this_thread::sleep_for(milliseconds(5));
    const bool in_time = done_;
    steering_->resume();
    tracer_.join();
    return in_time;
  }

  MirrorRoom room_{/*depth=*/2};
  render::Film film_{kWidth, kHeight};
  std::unique_ptr<Steering> steering_;
  TraceOptions options_;
  TraceResult result_;
  std::atomic<bool> done_ = false;
  std::thread tracer_;
};

TEST_P(Pause, HoldsThePictureAndLosesNothing) {
  render::Film reference(kWidth, kHeight);
  ASSERT_TRUE(trace(room_.context(), reference, {}).complete());
  begin("contribution");
  std::this_thread::sleep_for(milliseconds(60));
  const std::vector<render::Rgb> before = film_.snapshot();
  EXPECT_EQ(steering_->set_scheme("ray-type(shadow), level"), "");
  EXPECT_EQ(steering_->boost({.name = "middle", .kind = Boost::Kind::region, .region = {10, 10, 25, 20}}), "");
  std::this_thread::sleep_for(milliseconds(60));
  EXPECT_EQ(film_.snapshot(), before) << "something moved in a pause";
  EXPECT_FALSE(done_);
  steering_->resume();
  for (int i = 0; i < 5; ++i) {
    steering_->pause();
    std::this_thread::sleep_for(milliseconds(10));
    steering_->resume();
    std::this_thread::sleep_for(milliseconds(1));
  }
  EXPECT_TRUE(ends());
  EXPECT_TRUE(result_.complete()) << result_.error;
  EXPECT_EQ(film_.snapshot(), reference.snapshot());
}

TEST_P(Pause, DoesNotCountAsTracing) {
  begin("contribution");
  std::this_thread::sleep_for(milliseconds(700));
  steering_->stop();
  EXPECT_TRUE(ends());
  EXPECT_EQ(result_.end, End::stopped);
  EXPECT_LT(result_.statistics.seconds, 0.35);
}

TEST_P(Pause, EndsWithAStopFromAnySide) {
  begin("level");
  std::this_thread::sleep_for(milliseconds(20));
  steering_->stop();
  EXPECT_TRUE(ends());
  EXPECT_EQ(result_.end, End::stopped);

  std::atomic<bool> stop = false;
  begin("recursive", nullptr, &stop);
  std::this_thread::sleep_for(milliseconds(20));
  stop = true;
  EXPECT_TRUE(ends());
  EXPECT_EQ(result_.end, End::stopped);
}

/// Has no memory left for the picture that is asked for.
struct Failing final : Observer {
  void save(const Progress&) override { throw std::bad_alloc(); }
};

TEST_P(Pause, EndsWithAFailure) {
  Failing failing;
  begin("contribution", &failing);
  std::this_thread::sleep_for(milliseconds(20));
  steering_->save();
  EXPECT_TRUE(ends());
  EXPECT_EQ(result_.end, End::failed);
  EXPECT_EQ(result_.error, "not enough memory");
}

/// Sees the picture saved as it was when that was asked for.
struct Saving final : Observer {
  void save(const Progress& progress) override {
    ++saves;
    traced = progress.traced.total();
  }
  std::atomic<int> saves = 0;
  std::uint64_t traced = 0;
};

TEST_P(Pause, StillSavesPictures) {
  Saving saving;
  begin("contribution", &saving);
  steering_->save();
  for (int i = 0; i < 400 && saving.saves == 0; ++i) std::this_thread::sleep_for(milliseconds(5));
  EXPECT_EQ(saving.saves, 1);
  steering_->resume();
  EXPECT_TRUE(ends());
  EXPECT_LT(saving.traced, result_.statistics.rays.total());
}

INSTANTIATE_TEST_SUITE_P(Threads, Pause, testing::Values(1, 3),
                         [](const auto& info) { return std::to_string(info.param); });

}  // namespace
}  // namespace firstlight::priority
