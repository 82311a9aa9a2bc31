// The comparison itself: what it counts, and that it would notice.

#include "tests/golden/picture.h"
#include "tests/golden/process.h"
#include "tests/golden/scene_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <set>

namespace firstlight::golden {
namespace {

Picture grey(int width, int height, std::uint8_t value) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), value)};
}

TEST(Compare, EqualPicturesAgreeEverywhere) {
  const Comparison found = compare(grey(10, 10, 80), grey(10, 10, 80));
  EXPECT_EQ(found.share, 1);
  EXPECT_TRUE(std::isinf(found.psnr));
  EXPECT_EQ(found.worst, 0);
}

TEST(Compare, TwoStepsAgreeAndThreeDoNot) {
  Picture changed = grey(10, 10, 80);
  changed.rgb[0] = 82;
  EXPECT_EQ(compare(changed, grey(10, 10, 80)).share, 1);
  changed.rgb[0] = 83;
  EXPECT_DOUBLE_EQ(compare(changed, grey(10, 10, 80)).share, 0.99);
}

TEST(Compare, FindsTheWorstPixel) {
  Picture changed = grey(10, 10, 80);
  changed.rgb[3 * (4 * 10 + 7) + 1] = 200;
  changed.rgb[3 * (5 * 10 + 2)] = 90;
  const Comparison found = compare(changed, grey(10, 10, 80));
  EXPECT_EQ(found.worst, 120);
  EXPECT_EQ(found.x, 7);
  EXPECT_EQ(found.y, 4);
  EXPECT_EQ(found.first, (std::array<int, 3>{80, 200, 80}));
  EXPECT_EQ(found.second, (std::array<int, 3>{80, 80, 80}));
}

TEST(Compare, PsnrOfOneStepEverywhere) {
  // Mean squared difference 1: 20 log10(255) dB.
  EXPECT_NEAR(compare(grey(10, 10, 80), grey(10, 10, 81)).psnr, 48.13, 0.01);
}

TEST(Compare, DifferencePictureShowsASingleStep) {
  EXPECT_EQ(difference_picture(grey(2, 2, 80), grey(2, 2, 81)), grey(2, 2, 16));
  EXPECT_EQ(difference_picture(grey(2, 2, 0), grey(2, 2, 255)), grey(2, 2, 255));
}

TEST(ReadPicture, GivesBackWhatWasWritten) {
  const ScratchFolder scratch;
  Picture picture = grey(7, 5, 100);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) picture.rgb[i] = static_cast<std::uint8_t>(2 * i);
  ASSERT_TRUE(write_picture(picture, scratch / "a.png"));
  std::string why;
  EXPECT_EQ(read_picture(scratch / "a.png", why), picture) << why;
  EXPECT_FALSE(read_picture(scratch / "missing.png", why));
  EXPECT_NE(why, "");
}

TEST(RunProcess, TellsExitSignalAndTimeLimitApart) {
  const ScratchFolder scratch;
  const auto run = [&](const std::string& script, int limit) {
    return run_process({"sh", "-c", script}, scratch.path(), scratch.path(), std::chrono::seconds(limit));
  };
  const ProcessResult done = run("echo out; echo err >&2; exit 3", 20);
  EXPECT_EQ(done.exit_code, 3);
  EXPECT_EQ(done.out, "out\n");
  EXPECT_EQ(done.err, "err\n");
  EXPECT_EQ(run("kill -SEGV $$", 20).signal, SIGSEGV);
  const ProcessResult late = run("sleep 30", 1);
  EXPECT_TRUE(late.timed_out);
  EXPECT_LT(late.seconds, 20);
}

TEST(SceneList, ReadsTheErrorsThatASceneExpects) {
  const ScratchFolder scratch;
  const auto scene =
      scratch.write("a.pov", "x // expect error 4:12: expected '}'\r\n// expect error b.inc:5:1: found 'box'\n");
  const auto errors = expected_errors(scene);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].file, "a.pov");
  EXPECT_EQ(errors[0].line, 4);
  EXPECT_EQ(errors[0].column, 12);
  EXPECT_EQ(errors[0].message, "expected '}'");
  EXPECT_EQ(errors[1].file, "b.inc");
  EXPECT_EQ(errors[1].line, 5);
  EXPECT_EQ(errors[1].message, "found 'box'");
}

TEST(SceneList, HoldsTheScenesOfEveryFolder) {
  std::set<std::string> names;
  for (const GoldenScene& scene : golden_scenes()) {
    EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
    EXPECT_GE(scene.share, 98) << scene.name;
  }
  for (const char* name : {"shapes_sphere", "full_mirror_room", "povray_examples_language_macros_macro1"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

}  // namespace
}  // namespace firstlight::golden
