#include "app/progress.h"

#include "app/ending.h"

#include <gtest/gtest.h>

namespace firstlight::app {
namespace {

using priority::Progress;

Progress half_way() {
  Progress progress;
  progress.tiles = 10;
  progress.tiles_done = 10;
  progress.traced.of(render::RayKind::primary) = 1'000'000;
  progress.traced.of(render::RayKind::shadow) = 3'000'000;
  progress.rays_waiting = 4'000'000;
  progress.seconds = 2.0;
  progress.remaining = 0.0123;
  return progress;
}

TEST(Progress, ShortFormsStayShort) {
  EXPECT_EQ(short_count(0), "0");
  EXPECT_EQ(short_count(9'999), "9999");
  EXPECT_EQ(short_count(12'345), "12 k");
  EXPECT_EQ(short_count(19'000'000), "19.0 M");
  EXPECT_EQ(short_count(2'500'000'000), "2.50 G");
  EXPECT_EQ(short_time(3.417), "3.42 s");
  EXPECT_EQ(short_time(125.4), "2:05 min");
  EXPECT_EQ(short_time(7380.0), "2:03 h");
}

TEST(Progress, TellsABoundFromAnEstimate) {
  EXPECT_EQ(remaining_text(0.0123, true), "at most 0.0123 off");
  EXPECT_EQ(remaining_text(0.0123, false), "about 0.0123 off");
  EXPECT_EQ(remaining_text(0.0000123, true), "at most 1.2e-05 off");
  EXPECT_EQ(remaining_text(0.0, true), "at most 0.0000 off");
}

TEST(Progress, SaysHowFarThePictureIs) {
  EXPECT_EQ(progress_text(half_way(), 66.4, false),
            "refining 66 %, at most 0.0123 off, 4.0 M rays done, 4.0 M waiting, 2.0 M a second, 2.00 s");
  EXPECT_TRUE(progress_text(half_way(), 66.4, true).starts_with("paused at 66 %, "));
  Progress early = half_way();
  early.tiles_done = 5;
  EXPECT_TRUE(progress_text(early, 20.0, false).starts_with("first image 20 %, "));
}

TEST(Progress, GoesFromNothingToAHundredPerCent) {
  EXPECT_EQ(percent_done({}), 0.0);
  Progress progress = half_way();
  EXPECT_NEAR(percent_done(progress), 33.0 + 67.0 / 2, 0.01);
  progress.rays_waiting = 0;
  EXPECT_EQ(percent_done(progress), 100.0);
}

TEST(Summary, SaysWhatEndedAnUnfinishedPicture) {
  Options options;
  options.stop_after = 2.5;
  options.stop_at_error = 0.01;
  Stats stats;
  stats.width = 320;
  stats.height = 240;
  stats.rays.remaining = 0.25;
  EXPECT_TRUE(summary(options, "a.png", stats).starts_with("a.png: 320 x 240, 0 rays, trace "));
  stats.end = priority::End::time_over;
  EXPECT_TRUE(summary(options, "a.png", stats)
                  .starts_with("a.png: 320 x 240, not finished: stopped after 2.5 s, at most 0.2500 off; 0 rays"));
  stats.end = priority::End::error_reached;
  EXPECT_NE(summary(options, "a.png", stats).find("stopped at an error of 0.01 or less"), std::string::npos);
  stats.end = priority::End::stopped;
  stats.rays.remaining_is_bound = false;
  EXPECT_NE(summary(options, "a.png", stats).find("stopped by the user, about 0.2500 off"), std::string::npos);
  options.write_picture = false;
  EXPECT_TRUE(summary(options, "a.png", stats).starts_with("no picture written: "));
}

}  // namespace
}  // namespace firstlight::app
