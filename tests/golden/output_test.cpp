// Outputs that cannot be written: the standard streams, the files beside the picture, links.

#include "tests/golden/refusal.h"
#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"
#include "tests/golden/terminal.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>
#include <iterator>
#include <thread>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::chrono::seconds kSoon{60};

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs a line of the shell in the folder; $P is the program.
ProcessResult shell(const std::string& line, const ScratchFolder& scratch) {
  return run_process({"sh", "-c", fmt::format("P='{}'; {}", program_under_test(), line)}, scratch.path(),
                     scratch.path(), kRenderLimit);
}

/// A scene that says something before it is rendered, and opens a file.
fs::path talkative_scene(const ScratchFolder& scratch) {
  return scratch.write("scene.pov",
                       "#version 3.7; global_settings { assumed_gamma 1 }\n"
                       "#fopen File \"written.txt\" write\n#debug \"hello\\n\"\n#warning \"take care\"\n"
                       "#write (File, \"data\\n\")\n#fclose File\n"
                       "camera { location -5*z look_at 0 } sphere { 0, 1 pigment { rgb 1 } } light_source { -9*z, 1 }");
}

TEST(Output, WhatNobodyCanReadCostsNoPicture) {
  for (const char* streams :
       {"2>/dev/full", "2>&-", ">&- 2>&-", "<&- >&- 2>&-", "2>&1 | true", "2>&1 >/dev/full | true"}) {
    SCOPED_TRACE(streams);
    const ScratchFolder scratch;
    talkative_scene(scratch);
    const bool is_piped = std::string_view(streams).find('|') != std::string_view::npos;
    const auto result = shell(fmt::format("{{ $P scene.pov +W32 +H24 {}; echo $? > code; }} {}",
                                          is_piped ? "" : streams, is_piped ? streams : ""),
                              scratch);
    EXPECT_EQ(bytes_of(scratch / "code"), "0\n") << result.err;
    EXPECT_TRUE(fs::exists(scratch / "scene.png"));
    EXPECT_EQ(bytes_of(scratch / "written.txt"), "data\n") << "a message went into a file of the scene";
  }
}

TEST(Output, ATerminalThatGoesAwayCostsNoPictureWhenItsSignalIsIgnored) {
  const ScratchFolder scratch;
  {
    Terminal terminal({"sh", "-c",
                       fmt::format("trap '' HUP; '{}' '{}' +W640 +H480 +A0.1 +R3 +Opicture.png; echo $? > code",
                                   program_under_test(), (testscenes() / "full" / "still_life.pov").string())},
                      scratch.path());
    ASSERT_TRUE(terminal.wait_for("waiting", kSoon)) << terminal.text();
    terminal.go_away();
    for (const auto end = std::chrono::steady_clock::now() + kSoon;
         bytes_of(scratch / "code").empty() && std::chrono::steady_clock::now() < end;) {
      std::this_thread::sleep_for(20ms);
    }
  }
  EXPECT_EQ(bytes_of(scratch / "code"), "0\n");
  EXPECT_TRUE(fs::exists(scratch / "picture.png"));
}

TEST(Output, ATerminalThatGoesAwayEndsTheProgramWithoutAPicture) {
  const ScratchFolder scratch;
  Terminal terminal({program_under_test(), (testscenes() / "full" / "mirror_room.pov").string(), "+W3200", "+H2400",
                     "+Opicture.png", "--steer", "socket"},
                    scratch.path());
  ASSERT_TRUE(terminal.wait_for("? for keys", kSoon)) << terminal.text();
  terminal.go_away();
  EXPECT_EQ(terminal.wait_for_end(kSoon), 130);
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(Output, AResultThatCannotBeWrittenIsAnError) {
  const ScratchFolder scratch;
  talkative_scene(scratch);
  for (const char* line :
       {"$P scene.pov --parse-only >/dev/full", "$P scene.pov --parse-only --json >/dev/full", "$P --help >/dev/full",
        "$P --version >/dev/full", "$P study --help >/dev/full", "$P scene.pov --parse-only >&-"}) {
    SCOPED_TRACE(line);
    const auto result = shell(line, scratch);
    EXPECT_EQ(result.exit_code, 1) << result.summary();
    EXPECT_NE(result.err.find("cannot write to the standard output"), std::string::npos) << result.err;
  }
  EXPECT_EQ(shell("$P scene.pov --parse-only", scratch).exit_code, 0);
}

TEST(Output, FilesBesideThePictureThatCannotBeWrittenDoNotCostIt) {
  const ScratchFolder scratch;
  talkative_scene(scratch);
  const auto stats = shell("$P scene.pov +W32 +H24 --stats /dev/full", scratch);
  EXPECT_EQ(stats.exit_code, 1) << stats.summary();
  EXPECT_NE(stats.err.find("/dev/full"), std::string::npos) << stats.err;
  EXPECT_TRUE(fs::exists(scratch / "scene.png"));
  fs::remove(scratch / "scene.png");

  fs::create_directories(scratch / "shots" / "index.json");  // in the way of a file
  const auto snapshots = shell("$P scene.pov +W32 +H24 --snapshots shots", scratch);
  EXPECT_EQ(snapshots.exit_code, 1) << snapshots.summary();
  EXPECT_NE(snapshots.err.find("index.json"), std::string::npos) << snapshots.err;
  EXPECT_TRUE(fs::exists(scratch / "scene.png"));
}

TEST(Output, StatisticsInThePicturesPlaceAreRefused) {
  const ScratchFolder scratch;
  talkative_scene(scratch);
  fs::create_symlink("scene.png", scratch / "link.json");
  for (const char* file : {"scene.png", "./scene.png", "link.json"}) {
    SCOPED_TRACE(file);
    const auto result = shell(fmt::format("$P scene.pov +W32 +H24 --stats {}", file), scratch);
    EXPECT_EQ(result.exit_code, 1) << result.summary();
    EXPECT_NE(result.err.find("--stats"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(scratch / "scene.png"));
  }
}

TEST(Output, ALinkStaysALinkAndItsTargetIsMade) {
  const ScratchFolder scratch;
  talkative_scene(scratch);
  fs::create_directory(scratch / "there");
  fs::create_symlink("there/real.png", scratch / "next.png");
  fs::create_symlink("next.png", scratch / "picture.png");
  fs::create_symlink("there/real.json", scratch / "stats.json");
  for (int round = 0; round < 2; ++round) {  // first they lead nowhere
    const auto result = shell("$P scene.pov +W32 +H24 +Opicture.png --stats stats.json", scratch);
    EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
    for (const char* link : {"picture.png", "next.png", "stats.json"}) EXPECT_TRUE(fs::is_symlink(scratch / link));
    EXPECT_TRUE(fs::is_regular_file(scratch / "there" / "real.png"));
    EXPECT_TRUE(fs::is_regular_file(scratch / "there" / "real.json"));
  }
  const auto nowhere = shell("ln -s missing/real.png lost.png; $P scene.pov +W32 +H24 +Olost.png", scratch);
  EXPECT_EQ(nowhere.exit_code, 1) << nowhere.summary();
  EXPECT_TRUE(fs::is_symlink(scratch / "lost.png"));
}

TEST(Output, AFileThatMayNotGrowLeavesNoPartOfItself) {
  const ScratchFolder scratch;
  talkative_scene(scratch);
  const auto result = shell("ulimit -f 1; $P scene.pov +W400 +H300 +FP +Opicture.ppm", scratch);
  EXPECT_EQ(result.exit_code, 1) << result.summary();
  EXPECT_NE(result.err.find("picture.ppm"), std::string::npos) << result.err;
  fs::remove(scratch / "written.txt");
  fs::remove(scratch / "scene.pov");
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(Output, ControlCharactersOfNamesAreShown) {
  const ScratchFolder scratch;
  for (const char* line : {"$P \"$(printf 'no\\033[2Jsuch.pov')\"", "$P \"$(printf '+W\\033[2J')\" x.pov",
                           "$P scene.pov \"$(printf '+Ono\\033[2J/x.png')\"", "$P \"$(printf 'Wi\\033[2J=5')\"",
                           "$P scene.pov --steer \"$(printf 'no\\033[2J/x')\""}) {
    SCOPED_TRACE(line);
    talkative_scene(scratch);
    const auto result = shell(line, scratch);
    EXPECT_EQ(result.exit_code, 1) << result.summary();
    EXPECT_EQ(result.err.find('\033'), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("\\x1b[2J"), std::string::npos) << result.err;
  }
  const auto scheme = shell("$P scene.pov --scheme \"$(printf '\\033[2Jlevel')\"", scratch);
  EXPECT_EQ(scheme.err.find('\033'), std::string::npos) << scheme.err;
  EXPECT_NE(scheme.err.find("found '\\x1b'\n"), std::string::npos) << "its lines are lines: " << scheme.err;
}

}  // namespace
}  // namespace firstlight::golden
