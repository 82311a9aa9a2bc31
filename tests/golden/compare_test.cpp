// `firstlight compare`: scenes rendered by both programs, two pictures, and all that may keep them from being compared.

#include "tests/golden/picture.h"
#include "tests/golden/render.h"
#include "tests/golden/run.h"
#include "tests/golden/scene_list.h"
#include "tests/golden/terminal.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kSphere =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -5*z look_at 0 }\n"
    "light_source { -10*z rgb 1 }\nsphere { 0, 1 pigment { rgb 1 } }\n";

ProcessResult compare(const std::vector<std::string>& arguments, const ScratchFolder& scratch) {
  std::vector<std::string> command{program_under_test(), "compare"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_process(command, scratch.path(), scratch.path(), kRenderLimit);
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A program that is taken for POV-Ray. It writes the name of the picture that it is to make to the file `picture`.
fs::path stand_in(const ScratchFolder& scratch, const std::string& script) {
  const fs::path file =
      scratch.write("stand_in", "#!/bin/sh\nfor word in \"$@\"; do case $word in +O*) echo ${word#+O} > " +
                                    (scratch / "picture").string() + ";; esac; done\n" + script + "\n");
  fs::permissions(file, fs::perms::owner_all);
  return file;
}

fs::path write_grey(const ScratchFolder& scratch, const std::string& name, int width, int height, int value,
                    int grain = 0) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    picture.rgb.insert(picture.rgb.end(), 3, static_cast<std::uint8_t>(value + (i % 2 == 0 ? grain : -grain)));
  }
  EXPECT_EQ(render::write_picture((scratch / name).string(), picture), "");
  return scratch / name;
}

// ---- scenes ---------------------------------------------------------------------------------------------------------

class CompareAgrees : public testing::TestWithParam<const char*> {};

TEST_P(CompareAgrees, OnTheScene) {
  const std::string name = GetParam();
  const fs::path scene = name.starts_with('/') ? fs::path(name) : testscenes() / name;
  const ScratchFolder scratch;
  const ProcessResult result = compare({scene.string(), "--size", "80x60", "--json"}, scratch);
  EXPECT_EQ(result.exit_code, 0) << result.summary() << '\n' << result.out << result.err;
  const json said = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(said.is_object()) << result.out;
  EXPECT_EQ(said["status"], "agrees");
  EXPECT_EQ(said["difference"]["width"], 80);
  EXPECT_EQ(said["difference"]["height"], 60);
  EXPECT_GE(said["difference"]["share"], 0.98);
  for (const char* program : {"povray", "firstlight"}) {
    for (const char* measure : {"wall_s", "processor_s", "peak_bytes"})
      EXPECT_GT(said["medians"][program][measure], 0) << measure;
    EXPECT_EQ(said[program].size(), 1U);
  }
  EXPECT_GT(said["firstlight"][0]["trace_s"], 0.0);
  EXPECT_GT(said["ratios"]["wall_s"]["median"], 0.0);
  EXPECT_TRUE(said["missing"].empty());
}

INSTANTIATE_TEST_SUITE_P(Scenes, CompareAgrees,
                         testing::Values("shapes/sphere.pov", "patterns/checker.pov", "interior/refraction.pov",
                                         "lights/coloured_shadows.pov", "full/mirror_room.pov",
                                         "/usr/share/doc/povray/examples/language/macros/macro1.pov",
                                         "/usr/share/doc/povray/examples/incdemo/colors.pov"),
                         [](const auto& info) { return test_name(info.param); });

TEST(Compare, SaysHowFarAndHowLongAsText) {
  const ScratchFolder scratch;
  scratch.write("a scene.pov", kSphere);
  const ProcessResult result = compare({"a scene.pov", "+W64", "+H48", "--rounds", "2", "+A0.1"}, scratch);
  EXPECT_EQ(result.exit_code, 0) << result.summary() << '\n' << result.out << result.err;
  for (const char* part : {"a scene.pov, 64x48, 1 thread, 2 rounds: the pictures ", "within 2/255", "100.00 %",
                           "worst pixel", "mean, RMS error", "PSNR of 8x8 means", "FLIP", "medians (range)", "parse",
                           "trace", "whole, wall", "whole, processor", "memory", " to "}) {
    EXPECT_TRUE(contains(result.out, part)) << part << '\n' << result.out;
  }
  EXPECT_EQ(result.err, "");
}

TEST(Compare, TheIniFileSaysTheSizeUnlessTheUserDoes) {
  const ScratchFolder scratch;
  scratch.write("a.pov", kSphere);
  scratch.write("a.ini", "Input_File_Name=a.pov\nVerbose=Off\n[Small]\nWidth=40\nHeight=30\n");
  const auto size_with = [&](const std::vector<std::string>& arguments) {
    const ProcessResult result = compare(arguments, scratch);
    EXPECT_EQ(result.exit_code, 0) << result.summary() << '\n' << result.out << result.err;
    return json::parse(result.out, nullptr, false)["difference"]["width"];
  };
  EXPECT_EQ(size_with({"a.ini[Small]", "--json"}), 40);
  EXPECT_EQ(size_with({"a.pov", "a.ini[Small]", "--json", "+W20"}), 20);
}

TEST(Compare, NamesTheFeaturesThatAreMissing) {
  const ScratchFolder scratch;
  scratch.write("part.inc",
                "// one line\nsphere { 0, 0.1 interior { media { emission 1 } } hollow pigment { rgbt 1 } }\n");
  scratch.write("lacks.pov", std::string(kSphere) + "#include \"part.inc\"\nglobal_settings { radiosity { } }\n");
  const ProcessResult read = run_process({program_under_test(), "lacks.pov", "--parse-only", "--json"}, scratch.path(),
                                         scratch.path(), kRenderLimit);
  const json unrendered = json::parse(read.out, nullptr, false)["unrendered"];
  if (unrendered.empty()) GTEST_SKIP() << "nothing of this scene is missing any more";
  const ProcessResult result = compare({"lacks.pov", "--size", "32x24", "--json"}, scratch);
  EXPECT_EQ(result.exit_code, 4) << result.summary();
  for (const json& one : unrendered) {
    const std::string line = one["file"].get<std::string>() + ":" + std::to_string(one["line"].get<int>()) + ":" +
                             std::to_string(one["column"].get<int>()) + ": " + one["feature"].get<std::string>() + "\n";
    EXPECT_TRUE(contains(result.err, line)) << line << result.err;
  }
  const json said = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(said.is_object()) << result.out;
  EXPECT_EQ(said["status"], "lacks_features");
  EXPECT_EQ(said["missing"], unrendered);
  EXPECT_EQ(said["povray"].size(), 1U);
  EXPECT_TRUE(said["firstlight"].empty());
}

TEST(Compare, WithoutPovRaySaysHowToInstallIt) {
  const ScratchFolder scratch;
  scratch.write("a.pov", kSphere);
  const ProcessResult result =
      run_process({"/usr/bin/env", "PATH=/nonexistent", program_under_test(), "compare", "a.pov"}, scratch.path(),
                  scratch.path(), kRenderLimit);
  EXPECT_EQ(result.exit_code, 4) << result.summary();
  EXPECT_TRUE(contains(result.err, "apt-get install povray")) << result.err;
  EXPECT_EQ(compare({"a.pov", "--povray", "./no_such_program"}, scratch).exit_code, 4);
}

TEST(Compare, TellsWhichProgramRefusesTheScene) {
  const ScratchFolder scratch;
  // A name that is longer than POV-Ray reads.
  scratch.write("povray_refuses.pov", std::string(kSphere) + "#declare " + std::string(300, 'x') + " = 1;\n");
  const ProcessResult povray = compare({"povray_refuses.pov", "--size", "32x24"}, scratch);
  EXPECT_EQ(povray.exit_code, 4) << povray.summary();
  EXPECT_TRUE(contains(povray.err, "Firstlight renders it, POV-Ray does not")) << povray.err;
  EXPECT_TRUE(contains(povray.err, "line 6: Parse Error: String too long.")) << povray.err;

  scratch.write("words.txt", "1");
  scratch.write("nothing.conf", "[File I/O Security]\nrestricted\n[Permitted Paths]\nread = /nonexistent\n");
  scratch.write("we_refuse.pov", std::string(kSphere) + "#fopen F \"words.txt\" read\n");
  const ProcessResult ours = compare({"we_refuse.pov", "--size", "32x24", "--permissions", "nothing.conf"}, scratch);
  EXPECT_EQ(ours.exit_code, 4) << ours.summary();
  EXPECT_TRUE(contains(ours.err, "POV-Ray renders it, Firstlight does not")) << ours.err;
  EXPECT_TRUE(contains(ours.err, "error: ")) << ours.err;

  scratch.write("both_refuse.pov", std::string(kSphere) + "sphere { 0, 1 box\n");
  const ProcessResult both = compare({"both_refuse.pov", "--size", "32x24", "--json"}, scratch);
  EXPECT_EQ(both.exit_code, 4) << both.summary();
  EXPECT_TRUE(contains(both.err, "neither program renders it")) << both.err;
  EXPECT_EQ(json::parse(both.out, nullptr, false)["status"], "both_failed");
}

TEST(Compare, SurvivesAProgramThatCrashesOrHangs) {
  const ScratchFolder scratch;
  scratch.write("a.pov", kSphere);
  const auto with = [&](const std::string& script) {
    return compare({"a.pov", "--size", "32x24", "--time-limit", "2", "--povray", stand_in(scratch, script).string()},
                   scratch);
  };
  const ProcessResult crashed = with("kill -SEGV $$");
  EXPECT_EQ(crashed.exit_code, 4) << crashed.summary();
  EXPECT_TRUE(contains(crashed.err, "signal 11")) << crashed.err;
  const ProcessResult hung = with("sleep 100");
  EXPECT_EQ(hung.exit_code, 4) << hung.summary();
  EXPECT_TRUE(contains(hung.err, "time limit of 2 s")) << hung.err;
  const ProcessResult idle = with("exit 0");
  EXPECT_EQ(idle.exit_code, 4) << idle.summary();
  EXPECT_TRUE(contains(idle.err, "it wrote no picture")) << idle.err;
}

TEST(Compare, CtrlCEndsThePrograms) {
  const ScratchFolder scratch;
  const fs::path scene = scratch.write("a.pov", kSphere);
  const fs::path povray = stand_in(scratch, "echo $$ > " + (scratch / "process").string() + "\nsleep 100");
  Terminal terminal({program_under_test(), "compare", scene.string(), "--povray", povray.string()}, scratch.path());
  EXPECT_TRUE(terminal.wait_for("a.pov: POV-Ray", std::chrono::seconds(60)));
  for (int i = 0; i < 1200 && !(fs::exists(scratch / "process") && fs::file_size(scratch / "process") > 1); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  terminal.signal(SIGINT);
  EXPECT_EQ(terminal.wait_for_end(std::chrono::seconds(60)), 130);
  pid_t process = 0;
  std::ifstream(scratch / "process") >> process;
  ASSERT_GT(process, 1);
  EXPECT_NE(kill(process, 0), 0) << "the program that was taken for POV-Ray goes on";
  std::string picture;
  std::getline(std::ifstream(scratch / "picture"), picture);
  EXPECT_TRUE(picture.starts_with("/tmp/")) << picture;
  EXPECT_FALSE(fs::exists(fs::path(picture).parent_path())) << picture;
}

TEST(Compare, KeepsThePictures) {
  const ScratchFolder scratch;
  scratch.write("a.pov", kSphere);
  const ProcessResult result = compare({"a.pov", "--size", "32x24", "--keep", "new/folder", "--json"}, scratch);
  EXPECT_EQ(result.exit_code, 0) << result.summary() << '\n' << result.err;
  const json said = json::parse(result.out, nullptr, false);
  for (const auto& [name, key] : {std::pair("povray", "povray_picture"), std::pair("firstlight", "our_picture"),
                                  std::pair("difference", "difference_picture"), std::pair("flip", "flip_picture")}) {
    std::string why;
    const fs::path file = scratch / ("new/folder/" + std::string(name) + ".png");
    EXPECT_TRUE(read_picture(file, why)) << why;
    EXPECT_EQ(said[key], file.string());
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch / "new/folder"), fs::directory_iterator()), 4);
}

TEST(Compare, WhatASceneWritesIsMetByNobodyElse) {
  // In the scene's folder lies a file of that name: neither program may change it or take it for what it has written.
  const ScratchFolder scratch;
  scratch.write("size.txt", "9,\n");
  scratch.write("size.inc", "#fopen Out \"size.txt\" write\n#write (Out, 0.5, \",\\n\")\n#fclose Out\n");
  scratch.write(
      "a.pov",
      std::string(kSphere) +
          "#include \"size.inc\"\n#fopen In \"size.txt\" read\n#read (In, Size)\n#fclose In\n"
          "#if (Size != 0.5) #error \"another file\" #end\nbox { -Size, Size translate 2*x pigment { rgb 1 } }\n");
  const ProcessResult result = compare({"a.pov", "--size", "32x24", "--rounds", "2"}, scratch);
  EXPECT_EQ(result.exit_code, 0) << result.summary() << '\n' << result.out << result.err;
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()), 3);
  std::string kept;
  std::getline(std::ifstream(scratch / "size.txt"), kept);
  EXPECT_EQ(kept, "9,");
}

TEST(Compare, SaysWhereItCannotWrite) {
  const ScratchFolder scratch;
  scratch.write("a.pov", kSphere);
  scratch.write("file", "");
  const ProcessResult unwritable = compare({"a.pov", "--keep", "file/folder"}, scratch);
  EXPECT_EQ(unwritable.exit_code, 4) << unwritable.summary();
  EXPECT_TRUE(contains(unwritable.err, "file/folder")) << unwritable.err;

  fs::create_directory(scratch / "full");
  fs::create_symlink("/dev/full", scratch / "full/difference.png");
  const ProcessResult full = compare({"a.pov", "--size", "32x24", "--keep", "full"}, scratch);
  EXPECT_EQ(full.exit_code, 4) << full.summary();
  EXPECT_TRUE(contains(full.err, "No space left on device")) << full.err;

  const ProcessResult output =
      run_process({"sh", "-c", program_under_test() + " compare a.pov --size 32x24 >/dev/full"}, scratch.path(),
                  scratch.path(), kRenderLimit);
  EXPECT_EQ(output.exit_code, 4) << output.summary();
  EXPECT_TRUE(contains(output.err, "cannot write to the standard output")) << output.err;
}

TEST(Compare, RefusesWhatIsNoComparison) {
  const ScratchFolder scratch;
  scratch.write("a.pov", kSphere);
  for (const std::vector<std::string>& words : {std::vector<std::string>{},
                                                {"missing.pov"},
                                                {"a.png"},
                                                {"a.pov", "b.pov"},
                                                {"a.pov", "--nonsense"},
                                                {"a.pov", "+Wabc"},
                                                {"a.pov", "missing.ini"},
                                                {"a", "b", "c"}}) {
    const ProcessResult result = compare(words, scratch);
    EXPECT_EQ(result.exit_code, 4) << result.summary();
    EXPECT_TRUE(contains(result.err, "error: ")) << result.err;
  }
}

// ---- two pictures ---------------------------------------------------------------------------------------------------

TEST(ComparePictures, ExitStatusTellsHowFarTheyAreApart) {
  const ScratchFolder scratch;
  const std::string grey = write_grey(scratch, "grey.png", 16, 16, 80);
  const std::string same = write_grey(scratch, "same.ppm", 16, 16, 81);
  const std::string grainy = write_grey(scratch, "grainy.png", 16, 16, 80, 10);
  const std::string light = write_grey(scratch, "light.tga", 16, 16, 120);
  const std::string small = write_grey(scratch, "small.png", 16, 8, 80);
  const auto code = [&](const std::vector<std::string>& words) { return compare(words, scratch).exit_code; };
  EXPECT_EQ(code({grey, grey}), 0);
  EXPECT_EQ(code({grey, same}), 0);
  EXPECT_EQ(code({grey, grainy}), 1);
  EXPECT_EQ(code({grey, light}), 2);
  EXPECT_EQ(code({grey, small}), 3);
  EXPECT_EQ(code({grey, grainy, "--psnr", "28"}), 0);
  EXPECT_EQ(code({grey, grainy, "--share", "0"}), 0);
  EXPECT_EQ(code({grey, light, "--psnr", "15"}), 0);
  EXPECT_EQ(code({grey, light, "--psnr", "35", "--psnr-8x8", "15"}), 1);
}

TEST(ComparePictures, SaysTheNumbers) {
  const ScratchFolder scratch;
  const std::string grey = write_grey(scratch, "grey.png", 16, 16, 80);
  const std::string light = write_grey(scratch, "light.png", 16, 16, 120);
  const ProcessResult text = compare({grey, light, "--keep", "maps"}, scratch);
  EXPECT_TRUE(contains(text.out, "(0, 0), 40 of 255 apart: (80, 80, 80) in the first, (120, 120, 120) in the second"))
      << text.out;
  EXPECT_TRUE(fs::exists(scratch / "maps/difference.png"));
  EXPECT_TRUE(fs::exists(scratch / "maps/flip.png"));
  const json said = json::parse(compare({grey, grey, "--json"}, scratch).out, nullptr, false);
  ASSERT_TRUE(said.is_object());
  EXPECT_EQ(said["status"], "agrees");
  EXPECT_EQ(said["difference"]["share"], 1.0);
  EXPECT_TRUE(said["difference"]["psnr"].is_null());
}

TEST(ComparePictures, SaysWhatCannotBeCompared) {
  const ScratchFolder scratch;
  const std::string grey = write_grey(scratch, "grey.png", 16, 16, 80);
  const std::string small = write_grey(scratch, "small.png", 16, 8, 80);
  const std::string text = scratch.write("text.png", "not a picture").string();
  const ProcessResult size = compare({grey, small, "--json"}, scratch);
  EXPECT_TRUE(contains(size.err, "16x16") && contains(size.err, "16x8")) << size.err;
  EXPECT_EQ(json::parse(size.out, nullptr, false)["status"], "other_size");
  for (const auto& [first, second] :
       {std::pair(grey, text), std::pair(text, grey), std::pair(grey, std::string("no.png")),
        std::pair(grey, scratch.path().string())}) {
    const ProcessResult result = compare({first, second}, scratch);
    EXPECT_EQ(result.exit_code, 4) << result.summary();
    EXPECT_TRUE(contains(result.err, "cannot read '" + (first == grey ? second : first) + "'")) << result.err;
  }
}

}  // namespace
}  // namespace firstlight::golden
