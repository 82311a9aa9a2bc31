#include "app/compare/options.h"

#include "app/compare/programs.h"
#include "app/compare/scratch_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace firstlight::app::compare {
namespace {

CompareCommandLine parse(const std::vector<std::string>& words) { return parse_compare_command_line(words); }

TEST(CompareOptions, DefaultsArePovRaysOwn) {
  const CompareCommandLine line = parse({"a.pov"});
  EXPECT_TRUE(line.errors.empty());
  EXPECT_EQ(line.subjects, std::vector<std::string>{"a.pov"});
  EXPECT_EQ(line.settings.threads, 1);
  EXPECT_EQ(line.settings.rounds, 1);
  EXPECT_FALSE(line.settings.thresholds.share);
  EXPECT_FALSE(line.json);
}

TEST(CompareOptions, SizeInEveryForm) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--size", "64x48"}, {"--size=64x48"}, {"+W64", "+H48"}, {"Width=64", "Height=48"}}) {
    std::vector<std::string> all{"a.pov"};
    all.insert(all.end(), words.begin(), words.end());
    const CompareCommandLine line = parse(all);
    EXPECT_TRUE(line.errors.empty()) << words[0];
    EXPECT_EQ(line.settings.width, 64) << words[0];
    EXPECT_EQ(line.settings.height, 48) << words[0];
    EXPECT_TRUE(line.settings.words.empty()) << words[0];
  }
}

TEST(CompareOptions, SwitchesGoToBothAndOptionsToFirstlight) {
  const CompareCommandLine line = parse({"+Ia.pov", "+A0.1", "+R2", "-J", "declare=N=3", "--scheme", "level", "+WT2"});
  EXPECT_TRUE(line.errors.empty());
  EXPECT_EQ(line.subjects, std::vector<std::string>{"a.pov"});
  EXPECT_EQ(line.settings.words, (std::vector<std::string>{"+A0.1", "+R2", "-J", "declare=N=3"}));
  EXPECT_EQ(line.settings.our_words, std::vector<std::string>{"--scheme=level"});
  EXPECT_EQ(line.settings.threads, 2);
}

TEST(CompareOptions, PathsHoldInTheFolderOfTheScene) {
  const std::string here = std::filesystem::current_path().string();
  const CompareCommandLine line = parse({"a.pov", "+Linclude", "--keep", "out", "--povray", "./povray"});
  EXPECT_EQ(line.settings.words, std::vector<std::string>{"+L" + here + "/include"});
  EXPECT_EQ(line.keep, here + "/out");
  EXPECT_EQ(line.settings.povray, here + "/povray");
}

TEST(CompareOptions, TheSceneMayStandInTheIniFile) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "a.ini") << "Input_File_Name=a.pov\nWidth=50\n";
  std::ofstream(scratch / "a.pov") << "sphere { 0, 1 }\n";
  const CompareCommandLine line = parse({(scratch / "a.ini").string()});
  EXPECT_TRUE(line.errors.empty());
  EXPECT_EQ(line.ini, scratch / "a.ini");
  EXPECT_EQ(line.subjects, std::vector<std::string>{(scratch / "a.pov").string()});
}

TEST(CompareOptions, WhatMeansNothingIsRefused) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--size", "64"},
                                                {"--size", "0x10"},
                                                {"--rounds", "0"},
                                                {"--share", "101"},
                                                {"--share"},
                                                {"--psnr", "x"},
                                                {"--nonsense"},
                                                {"+Wabc"},
                                                {"+Oout.png"},
                                                {"-F"},
                                                {"--stats", "x"},
                                                {"+KFF10"},
                                                {"--time-limit", "0"},
                                                {"--threads", "100000"},
                                                {"--scheme", "nonsense"},
                                                {"+MV3.5"},
                                                {"--keep="}}) {
    std::vector<std::string> all{"a.pov"};
    all.insert(all.end(), words.begin(), words.end());
    EXPECT_FALSE(parse(all).errors.empty()) << words[0];
  }
}

TEST(PovRayText, TellsItsTimes) {
  const std::string printed =
      "Trace Time: (77.0 seconds) says the scene\n"
      "  Parse Time:       0 hours  0 minutes  1 seconds (1.025 seconds)\n"
      "              using 1 thread(s) with 0.001 CPU-seconds total\n"
      "  Photon Time:      No photons\n"
      "  Trace Time:       0 hours  0 minutes 13 seconds (13.633 seconds)\n";
  EXPECT_EQ(povray_seconds("Parse Time:", printed), 1.025);
  EXPECT_EQ(povray_seconds("Trace Time:", printed), 13.633);
  EXPECT_EQ(povray_seconds("Photon Time:", printed), 0.0);
  EXPECT_EQ(povray_seconds("Bounding Time:", printed), 0.0);
}

TEST(PovRayText, TellsItsErrorInOneLine) {
  EXPECT_EQ(povray_error("==== [Parsing...]\n"
                         "File 'a.pov' line 3: Parse Warning: something\n"
                         "File 'er.pov' line 2: Parse Error: Parse halted by #error directive: my own\n"
                         " error text\n"
                         "Fatal error in parser: Cannot parse input.\n"
                         "Render failed\n"),
            "File 'er.pov' line 2: Parse Error: Parse halted by #error directive: my own error text");
  // A word that is longer than the line is cut where the line is full.
  const std::string full(79, 'x');
  EXPECT_EQ(povray_error("File 'a' line 1: Parse Error: " + full.substr(30) + "\nyy found\nRender failed\n"),
            "File 'a' line 1: Parse Error: " + full.substr(30) + "yy found");
  // So is a message that just fits.
  EXPECT_EQ(povray_error("File 'a' line 1: Parse Error: " + full.substr(29) + "\nFatal error in parser: no\n"),
            "File 'a' line 1: Parse Error: " + full.substr(29));
  EXPECT_EQ(povray_error("Cannot create render state output file.\nRender failed\n"),
            "Cannot create render state output file.");
  EXPECT_EQ(povray_error("Possible Parse Error: Cannot find file 'a'\nParse Error: Cannot open input file.\n"),
            "Parse Error: Cannot open input file.");
  EXPECT_EQ(povray_error(""), "");
}

}  // namespace
}  // namespace firstlight::app::compare
