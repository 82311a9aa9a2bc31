// `firstlight compare` of many scenes: what goes wrong in one does not end the others, and what was stopped goes on.

#include "tests/golden/run.h"
#include "tests/golden/scene_list.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kLimit{240};
constexpr const char* kRoom = "camera { location -5*z look_at 0 }\nlight_source { <3, 4, -5> rgb 1 }\n";

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Five small scenes, and a POV-Ray that crashes in one of them, and hangs in another as long as there is the file `hang`.
class CompareMany : public ::testing::Test {
 protected:
  CompareMany() {
    fs::create_directories(scratch_ / "scenes/deep");
    scratch_.write("scenes/a_good.pov", std::string(kRoom) + "#include \"ball.inc\"");
    scratch_.write("scenes/ball.inc", "sphere { 0, 1 pigment { rgb 1 } }");
    scratch_.write("scenes/b_lacks.pov", std::string(kRoom) + "media { emission 0.1 }");
    scratch_.write("scenes/c_hangs.pov", std::string(kRoom) + "sphere { 0, 1 pigment { rgb 1 } }");
    scratch_.write("scenes/d_crashes.pov", std::string(kRoom) + "box { -1, 1 pigment { rgb 1 } }");
    scratch_.write("scenes/deep/broken.pov", "sphere { 0, 1\nbox { 0, 1 }");
    scratch_.write("hang", "");
    const fs::path povray = scratch_.write(
        "povray", fmt::format("#!/bin/sh\ncase \"$*\" in\n*c_hangs*) while [ -e {}/hang ]; do sleep 0.1; done;;\n"
                              "*d_crashes*) kill -SEGV $$;;\nesac\nexec povray \"$@\"\n",
                              scratch_.path().string()));
    fs::permissions(povray, fs::perms::owner_all);
  }

  std::vector<std::string> command(const std::vector<std::string>& more) const {
    std::vector<std::string> words{program_under_test(), "compare", "scenes", "--size", "32x24",
                                   "--povray",           "./povray"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  ProcessResult run(const std::vector<std::string>& words) const {
    return run_process(words, scratch_.path(), scratch_.path(), kLimit);
  }

  /// The outcome of the scenes, without the times.
  std::string verdicts(const std::string& file) const {
    const auto json = nlohmann::json::parse(text_of(scratch_ / file));
    std::string text = json["totals"]["status"].dump() + json["totals"]["missing"].dump();
    for (const auto& scene : json["scenes"]) {
      text += fmt::format("\n{} {}", scene["name"].get<std::string>(), scene["status"].get<std::string>());
    }
    return text;
  }

  ScratchFolder scratch_;
};

TEST_F(CompareMany, OneThatHangsAndOneThatCrashesAreTwoOfMany) {
  const ProcessResult result = run(
      command({"--cache", "cache", "--json=all.json", "--agreement", "page.md", "--jobs", "2", "--time-limit", "20"}));
  EXPECT_EQ(result.exit_code, 4) << result.summary() << '\n' << result.err;
  const auto json = nlohmann::json::parse(text_of(scratch_ / "all.json"));
  std::vector<std::string> found;
  for (const auto& scene : json["scenes"]) {
    found.push_back(fmt::format("{} {}", scene["name"].get<std::string>(), scene["status"].get<std::string>()));
  }
  EXPECT_EQ(found, (std::vector<std::string>{"a_good agrees", "b_lacks lacks_features", "c_hangs povray_failed",
                                             "d_crashes povray_failed", "deep/broken both_failed"}));
  EXPECT_EQ(json["totals"]["missing"].size(), 1u);
  EXPECT_NE(result.out.find("5 scenes: 1 agrees, 1 lacks features, 2 POV-Ray failed, 1 both failed"), std::string::npos)
      << result.out;
  EXPECT_NE(text_of(scratch_ / "page.md").find("| a\\_good | agrees | 100.00 % |"), std::string::npos);
}

TEST_F(CompareMany, GoesOnAfterCtrlCWithTheSameTotals) {
  const std::vector<std::string> words = command({"--cache", "cache", "--json=resumed.json"});
  std::string line;
  for (const std::string& word : words) line += "'" + word + "' ";
  // Interrupted while POV-Ray hangs in the third scene.
  const ProcessResult stopped =
      run({"sh", "-c",
           line + " >out.txt 2>err.txt & pid=$!; until grep -q b_lacks out.txt; do sleep 0.05; "
                  "done; kill -INT $pid; wait $pid"});
  EXPECT_EQ(stopped.exit_code, 130) << stopped.summary();
  EXPECT_NE(text_of(scratch_ / "err.txt").find("2 of 5 scenes are done; the same command goes on"), std::string::npos)
      << text_of(scratch_ / "err.txt");
  EXPECT_FALSE(fs::exists(scratch_ / "resumed.json"));
  fs::remove(scratch_ / "hang");

  const ProcessResult resumed = run(words);
  EXPECT_EQ(resumed.exit_code, 4) << resumed.err;
  EXPECT_NE(resumed.out.find("2 of them done before"), std::string::npos) << resumed.out;
  const ProcessResult whole = run(command({"--cache", "other", "--json=whole.json"}));
  EXPECT_EQ(verdicts("resumed.json"), verdicts("whole.json"));
}

TEST_F(CompareMany, AListNamesScenesBelowAFolder) {
  scratch_.write("list.txt", "# two of them\na_good\na_good.pov +A0.3\n");
  const ProcessResult result =
      run({program_under_test(), "compare", "--list", "list.txt", "--root", "scenes", "--size", "32x24", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.summary() << '\n' << result.err;
  const auto json = nlohmann::json::parse(result.out);
  ASSERT_EQ(json["scenes"].size(), 2u);
  EXPECT_EQ(json["scenes"][0]["name"], "a_good");
  EXPECT_EQ(json["scenes"][1]["name"], "a_good +A0.3");
  EXPECT_TRUE(fs::is_directory(scratch_ / ".cache/firstlight/compare")) << "below HOME, when nothing else is said";
}

TEST_F(CompareMany, WhatCannotBeDoneIsToldBeforeAnythingIsRendered) {
  scratch_.write("list.txt", "a_good\ngone\n");
  fs::create_directories(scratch_ / "full");
  scratch_.write("full/letter.txt", "dear");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"compare", "--list", "list.txt", "--root", "scenes"}, "list.txt:2: there is no scene 'gone'"},
      {{"compare", "--list", "none.txt"}, "there is no list 'none.txt'"},
      {{"compare", "full"}, "there is no .pov file below 'full'"},
      {{"compare", "scenes", "--report", "full"}, "something that is no report"},
      {{"compare", "scenes", "--report", "list.txt/below"}, "list.txt"},
      {{"compare", "scenes", "--agreement", "none/page.md"}, "there is no folder 'none'"},
      {{"compare", "scenes", "--jobs", "none"}, "--jobs: expected a number"},
      {{"compare", "scenes", "--cache"}, "option '--cache': expected a value"},
      {{"compare", "scenes", "--cache", "list.txt"}, "cannot make the folder 'list.txt'"},
      {{"compare", "scenes", "--list", "list.txt"}, "expected one of them"},
      {{"compare", "scenes", "--povray", "./none"}, "none"},
  };
  for (const auto& [words, message] : cases) {
    std::vector<std::string> whole{program_under_test()};
    whole.insert(whole.end(), words.begin(), words.end());
    const ProcessResult result = run(whole);
    EXPECT_EQ(result.exit_code, 4) << result.summary() << " " << message;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "") << message;
  }
  EXPECT_EQ(text_of(scratch_ / "full/letter.txt"), "dear");
}

}  // namespace
}  // namespace firstlight::golden
