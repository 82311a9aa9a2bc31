// The command line and the files it names: what is refused, and what the options do.

#include "tests/golden/picture.h"
#include "tests/golden/refusal.h"
#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <random>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

const fs::path kScene = testscenes() / "shapes" / "sphere.pov";

// ---- refused ---------------------------------------------------------------------------------------------------

TEST(Refuses, AMissingFileAndNamesIt) {
  const ScratchFolder scratch;
  const auto result = expect_refusal(scratch / "no_such_scene.pov", scratch);
  EXPECT_NE(result.err.find("no_such_scene.pov"), std::string::npos) << result.err;
}

TEST(Refuses, AFolderInPlaceOfAScene) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "folder.pov");
  const auto result = expect_refusal(scratch / "folder.pov", scratch);
  EXPECT_NE(result.err.find("folder.pov"), std::string::npos) << result.err;
}

TEST(Refuses, ABinaryFile) {
  const ScratchFolder scratch;
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    std::mt19937 random(seed);
    std::string bytes(200000, '\0');
    for (char& c : bytes) c = static_cast<char>(random() & 0xFFU);
    bytes[5] = '\0';
    const auto result = expect_refusal(scratch.write("binary.pov", bytes), scratch);
    EXPECT_NE(result.err.find("binary.pov:"), std::string::npos) << result.err.substr(0, 1000);
    // A message for a person: control characters would garble the terminal.
    EXPECT_TRUE(std::none_of(result.err.begin(), result.err.end(), [](char c) { return c == '\0' || c == '\033'; }));
  }
}

TEST(Refuses, AFileOfZeros) {
  const ScratchFolder scratch;
  expect_refusal(scratch.write("zeros.pov", std::string(100000, '\0')), scratch);
}

TEST(Refuses, AnOutputFolderThatDoesNotExist) {
  const ScratchFolder scratch;
  const auto picture = scratch / "no_such_folder" / "picture.png";
  const auto result = expect_command_refused({"+I" + kScene.string(), "+O" + picture.string(), "-D"}, picture, scratch);
  EXPECT_NE(result.err.find("no_such_folder"), std::string::npos) << result.err;
  EXPECT_FALSE(fs::exists(scratch / "no_such_folder"));
}

TEST(Refuses, AnOutputThatIsAFolder) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "picture.png");
  const auto result = run_process(
      {program_under_test(), "+I" + kScene.string(), "+O" + (scratch / "picture.png").string(), "+W32", "+H24", "-D"},
      scratch.path(), scratch.path(), std::chrono::seconds(30));
  EXPECT_EQ(result.exit_code, 1) << result.summary();
  EXPECT_TRUE(fs::is_directory(scratch / "picture.png"));
  EXPECT_TRUE(fs::is_empty(scratch / "picture.png"));
}

TEST(Refuses, OptionsThatMeanNothing) {
  const ScratchFolder scratch;
  const auto picture = scratch / "picture.png";
  const std::string scene = "+I" + kScene.string();
  const std::string output = "+O" + picture.string();
  for (const char* option :
       {"+W0", "+W-5", "+Wabc", "+H99999999999", "--scheme=nonsense", "--threads=-1", "--no-such-option", "+WT0x"}) {
    SCOPED_TRACE(option);
    expect_command_refused({scene, output, "-D", option}, picture, scratch);
  }
}

TEST(Refuses, ACommandLineWithoutAScene) {
  const ScratchFolder scratch;
  const auto result = run_process({program_under_test()}, scratch.path(), scratch.path(), std::chrono::seconds(30));
  EXPECT_EQ(result.exit_code, 1) << result.summary();
  EXPECT_NE(result.out + result.err, "");
}

TEST(Refuses, AFrontEndThatIsNotAModule) {
  const ScratchFolder scratch;
  const auto picture = scratch / "picture.png";
  for (const fs::path& module : {scratch / "missing.so", scratch.write("text.so", "not a module"),
                                 fs::path("/lib/x86_64-linux-gnu/libc.so.6")}) {
    SCOPED_TRACE(module);
    expect_command_refused({"+I" + kScene.string(), "+O" + picture.string(), "-D", "--front-end", module.string()},
                           picture, scratch);
  }
}

TEST(Refuses, WhatTheFilesOfPermissionsDoNotPermit) {
  const ScratchFolder scratch;
  const auto picture = scratch / "picture.png";
  const auto scene = scratch.write("scene.pov",
                                   "#version 3.7; global_settings { assumed_gamma 1 } camera { look_at z }\n"
                                   "#fopen Out \"out.txt\" write\n");
  const auto reading = scratch.write("reading.conf", "[File I/O Security]\nread-only\n");
  const auto misspelt = scratch.write("misspelt.conf", "[File I/O Security]\nreadonly\n");
  for (const auto& [conf, part] :
       {std::pair{reading, "out.txt"}, {misspelt, "readonly"}, {scratch / "none.conf", "none.conf"}}) {
    SCOPED_TRACE(conf);
    const auto result = expect_command_refused(
        {"+I" + scene.string(), "+O" + picture.string(), "--permissions", conf.string()}, picture, scratch);
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(scratch / "out.txt"));
  }
}

TEST(Refuses, AnUnknownSchemeAMalformedOneAndABoostOfNothing) {
  const ScratchFolder scratch;
  const auto picture = scratch / "picture.png";
  for (const auto& [option, text, part] : {std::array{"--scheme", "contributoin", "contribution"},
                                           {"--scheme", "level, nothing", "nothing"},
                                           {"--scheme", "level level", "column 7"},
                                           {"--boost", "object Nothing", "Nothing"},
                                           {"--boost", "light 99", "light 99"},
                                           {"--boost", "region 9 9 1 1", "empty"},
                                           {"--boost", "place", "place"}}) {
    SCOPED_TRACE(text);
    const auto result =
        expect_command_refused({"+I" + kScene.string(), "+O" + picture.string(), option, text}, picture, scratch);
    EXPECT_NE(result.err.find(option), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
  }
}

TEST(Refuses, AnImpossibleBudget) {
  const ScratchFolder scratch;
  const auto picture = scratch / "picture.png";
  for (const char* size : {"1k", "0", "lots", "-5M"}) {
    const auto result = expect_command_refused(
        {"+I" + kScene.string(), "+O" + picture.string(), "--queue-memory", size}, picture, scratch);
    EXPECT_NE(result.err.find("--queue-memory"), std::string::npos) << result.err;
  }
}

TEST(Refuses, AnIniFileWithAMistakeByItsLine) {
  const ScratchFolder scratch;
  const auto picture = scratch / "picture.png";
  const auto ini = scratch.write("room.ini", "Input_File_Name=" + kScene.string() + "\nStop_After=soon\n");
  const auto result = expect_command_refused({ini.string(), "+O" + picture.string()}, picture, scratch);
  EXPECT_NE(result.err.find(ini.string() + ":2: "), std::string::npos) << result.err;
}

// ---- done --------------------------------------------------------------------------------------------------------

/// A picture of `kScene` with these options, which must succeed.
Picture picture_with(const std::vector<std::string>& options, const ScratchFolder& scratch) {
  std::string why;
  const auto file = scratch / "picture.png";
  const auto result = render(program_under_test(), kScene, file, scratch.path(), options);
  EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
  const auto picture = read_picture(file, why);
  EXPECT_TRUE(picture) << why;
  fs::remove(file);
  return picture.value_or(Picture{});
}

TEST(CommandLine, LeavesOnlyThePictureItWasAskedFor) {
  const ScratchFolder scratch;
  const auto scene = scratch.write("scene.pov", "camera { location -5*z look_at 0 } sphere { 0, 1 pigment { rgb 1 } }");
  const auto result = run_process({program_under_test(), scene.string(), "+W32", "+H24", "-D"}, scratch.path(),
                                  scratch.path(), kRenderLimit);
  ASSERT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(scratch.path())) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"scene.png", "scene.pov"}));
}

TEST(CommandLine, TakesWidthAndHeight) {
  const ScratchFolder scratch;
  const Picture picture = picture_with({"+W33", "+H21"}, scratch);
  EXPECT_EQ(picture.width, 33);
  EXPECT_EQ(picture.height, 21);
}

TEST(CommandLine, TakesTheSceneAsAWordToo) {
  const ScratchFolder scratch;
  const Picture expected = picture_with({}, scratch);
  const auto file = scratch / "as_a_word.png";
  const auto result = run_process({program_under_test(), kScene.string(), "+O" + file.string(), "+W160", "+H120", "-D"},
                                  scratch.path(), scratch.path(), kRenderLimit);
  ASSERT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
  std::string why;
  EXPECT_EQ(read_picture(file, why), expected) << why;
}

TEST(CommandLine, TakesTheOptionsThatPovRaysCallersPass) {
  const ScratchFolder scratch;
  EXPECT_EQ(picture_with({"-A", "-J", "-V", "+V", "-D", "+FN", "-P", "-GA", "+Q9"}, scratch),
            picture_with({}, scratch));
}

TEST(CommandLine, FindsIncludedFilesInALibraryFolder) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "library");
  scratch.write("library/part.inc", "sphere { 0, 1 pigment { rgb 1 } }\n");
  const auto scene = scratch.write("scene.pov", "#include \"part.inc\"\ncamera { location -5*z look_at 0 }\n");
  expect_refusal(scene, scratch);
  const auto result = render(program_under_test(), scene, scratch / "picture.png", scratch.path(),
                             {"+L" + (scratch / "library").string()});
  EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
}

TEST(CommandLine, TakesItsOptionsFromAnIniFileToo) {
  const ScratchFolder scratch;
  const auto ini = scratch.write("room.ini",
                                 "; settings of ours and of POV-Ray\nScheme=level\nWidth=999\n+H999\n[Small]\n"
                                 "Width = 32 ; a comment\n+H24 -A\nQueue_Memory=1M\n");
  EXPECT_EQ(picture_with({ini.string() + "[small]"}, scratch), picture_with({"+W32", "+H24"}, scratch));
}

TEST(CommandLine, ALoadedFrontEndMakesTheSamePicture) {
  const ScratchFolder scratch;
  EXPECT_EQ(picture_with({"--front-end", FIRSTLIGHT_POV_MODULE}, scratch), picture_with({}, scratch));
}

TEST(CommandLine, StatsHoldEveryNumber) {
  const ScratchFolder scratch;
  const auto file = scratch / "stats.json";
  picture_with({"--stats", file.string(), "--scheme", "level", "--threads", "2"}, scratch);
  std::ifstream stream(file);
  const auto stats = nlohmann::json::parse(stream, nullptr, /*allow_exceptions=*/false);
  ASSERT_TRUE(stats.is_object());
  EXPECT_EQ(stats.value("scheme", ""), "level");
  EXPECT_EQ(stats.value("threads", 0), 2);
  EXPECT_EQ(stats.value("width", 0), 160);
  EXPECT_EQ(stats.value("height", 0), 120);
  for (const char* path : {"/time/parse_s", "/time/build_s", "/time/first_image_s", "/time/trace_s", "/time/total_s",
                           "/rays/primary", "/rays/reflection", "/rays/transmission", "/rays/shadow", "/time/preview_s",
                           "/end/remaining", "/rekeying/count", "/queue/memory", "/queue/peak_rays",
                           "/queue/peak_bytes", "/queue/bytes_per_ray", "/queue/worst_case_rays"}) {
    const nlohmann::json::json_pointer pointer(path);
    ASSERT_TRUE(stats.contains(pointer)) << path;
    EXPECT_TRUE(stats.at(pointer).is_number()) << path;
  }
  EXPECT_EQ(stats.at("/rays/primary"_json_pointer), 160 * 120);
  EXPECT_LE(stats.at("/time/first_image_s"_json_pointer), stats.at("/time/total_s"_json_pointer));
}

TEST(CommandLine, SnapshotsAreReadablePictures) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "snapshots");
  picture_with({"+W640", "+H480", "--snapshots", (scratch / "snapshots").string()}, scratch);
  int count = 0;
  for (const auto& entry : fs::directory_iterator(scratch / "snapshots")) {
    if (entry.path().extension() != ".png") continue;
    std::string why;
    const auto picture = read_picture(entry.path(), why);
    ASSERT_TRUE(picture) << entry.path() << ": " << why;
    EXPECT_EQ(picture->width, 640);
    ++count;
  }
  EXPECT_GE(count, 1);
}

}  // namespace
}  // namespace firstlight::golden
