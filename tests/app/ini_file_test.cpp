#include "app/ini_file.h"

#include "app/options.h"
#include "tests/app/folder.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace firstlight::app {
namespace {

using Words = std::vector<std::string>;

/// Number and words of each line that counts.
std::vector<std::pair<int, Words>> lines_of(std::string_view text, std::string_view section = {}) {
  std::vector<std::pair<int, Words>> out;
  for (const IniLine& line : parse_ini(text, section).lines) out.emplace_back(line.number, line.words);
  return out;
}

using Lines = std::vector<std::pair<int, Words>>;

TEST(IniText, HasSettingsSwitchesAndComments) {
  EXPECT_EQ(lines_of("; all of this is a comment\n"
                     "\n"
                     "  Width = 640   ; a setting\r\n"
                     "+W80 +H60      # switches\n"
                     "more.ini\n"
                     "Scheme=level"),
            (Lines{{3, {"Width=640"}}, {4, {"+W80", "+H60"}}, {5, {"more.ini"}}, {6, {"Scheme=level"}}}));
}

TEST(IniText, QuotesKeepBlanksAndCommentMarks) {
  EXPECT_EQ(lines_of("Input_File_Name=\"my ; file.pov\"\n+I'my \"big\" file.pov' +W3\n\"a b.ini\"\n"),
            (Lines{{1, {"Input_File_Name=my ; file.pov"}}, {2, {"+Imy \"big\" file.pov", "+W3"}}, {3, {"a b.ini"}}}));
  // A quote that nothing closes is part of a name.
  EXPECT_EQ(lines_of("Input_File_Name=bob's.pov ; of Bob"), (Lines{{1, {"Input_File_Name=bob's.pov"}}}));
}

TEST(IniText, AValueOfSeveralWordsStaysWhole) {
  EXPECT_EQ(lines_of("Scheme = region(0,0,9,9), 0.7*contribution + 0.3*level"),
            (Lines{{1, {"Scheme=region(0,0,9,9), 0.7*contribution + 0.3*level"}}}));
  EXPECT_EQ(lines_of("Library_Path=one, \"two, three\""),
            (Lines{{1, {"Library_Path=one", "Library_Path=two, three"}}}));
  EXPECT_EQ(lines_of("Declare=A=1"), (Lines{{1, {"Declare=A=1"}}}));
  EXPECT_EQ(lines_of("Width="), (Lines{{1, {"Width="}}}));
}

TEST(IniText, ReadsWhatStandsBeforeAllSectionsAndTheNamedOne) {
  const std::string text = "+W1\n[Low]\n+W2\n[Really High]\n+W3\n[low]\n+W4\n";
  EXPECT_EQ(lines_of(text), (Lines{{1, {"+W1"}}}));
  EXPECT_EQ(lines_of(text, "LOW"), (Lines{{1, {"+W1"}}, {3, {"+W2"}}, {7, {"+W4"}}}));
  EXPECT_EQ(lines_of(text, "Really High"), (Lines{{1, {"+W1"}}, {5, {"+W3"}}}));
  EXPECT_FALSE(parse_ini(text, "none").has_section);
  EXPECT_EQ(parse_ini(text, "").sections, (Words{"Low", "Really High", "low"}));
}

TEST(IniText, SurvivesAnyBytes) {
  for (const std::string text : {"[", "[a", "]", "=", "=1", "\"", "'\"'", "\n\n[\n=\n", "\xff\xfe=\x01", "+", "-"}) {
    EXPECT_LE(parse_ini(text, "a").lines.size(), 3u);
  }
}

// ---- as arguments ------------------------------------------------------------------------------------------------

CommandLine parse(const Words& words) { return parse_command_line(words); }

std::string first_error(const CommandLine& line) { return line.errors.empty() ? "" : line.errors.front(); }

TEST(IniFile, HoldsOurSettingsAndPovRays) {
  const Folder folder;
  const std::string file = folder.write("scene.ini",
                                        "Input_File_Name=room.pov\nWidth=64\n+H48\nScheme=level\nQueue_Memory=16M\n"
                                        "Stop_At_Error=0.01\nSTOP_AFTER=2.5\nboost=light 1\nBoost=region 0 0 9 9\n"
                                        "Steer=here.socket\nQuiet=on\n");
  const CommandLine line = parse({file});
  ASSERT_EQ(first_error(line), "");
  EXPECT_EQ(line.options.scene, "room.pov");
  EXPECT_EQ(line.options.width, 64);
  EXPECT_EQ(line.options.height, 48);
  EXPECT_EQ(line.options.scheme, "level");
  EXPECT_EQ(line.options.queue_memory, 16u << 20);
  EXPECT_EQ(line.options.stop_at_error, 0.01);
  EXPECT_EQ(line.options.stop_after, 2.5);
  EXPECT_EQ(line.options.boosts, (Words{"light 1", "region 0 0 9 9"}));
  EXPECT_EQ(line.options.steer, "here.socket");
  EXPECT_TRUE(line.options.quiet);
}

TEST(IniFile, WhatIsSaidLaterCounts) {
  const Folder folder;
  const std::string file = folder.write("a.ini", "Width=64\nScheme=level\n[big]\nWidth=640\n");
  EXPECT_EQ(parse({"a.pov", "+W10", file}).options.width, 64);
  EXPECT_EQ(parse({"a.pov", file, "+W10"}).options.width, 10);
  EXPECT_EQ(parse({"a.pov", file + "[Big]"}).options.width, 640);
  EXPECT_EQ(parse({"a.pov", file, "--scheme", "recursive"}).options.scheme, "recursive");
  EXPECT_EQ(parse({"a.pov", "--scheme=recursive", file}).options.scheme, "level");
}

TEST(IniFile, ExtensionMayBeLeftAwayAndFoldersAreSearched) {
  const Folder folder;
  folder.write("quick.ini", "Width=64\n");
  EXPECT_EQ(parse({"a.pov", folder / "quick"}).options.width, 64);
  EXPECT_EQ(parse({"a.pov", "+L" + folder.path.string(), "quick.ini"}).options.width, 64);
}

TEST(IniFile, ASectionMayHoldAScheme) {
  const Folder folder;
  const std::string file = folder.write("orders.ini", "[mirrors]\nScheme=ray-type\n[flat]\nScheme=level\n");
  EXPECT_EQ(parse({"a.pov", file + "[mirrors]"}).options.scheme, "ray-type");
  EXPECT_EQ(parse({"a.pov", file + "[flat]"}).options.scheme, "level");
}

TEST(IniFile, MistakesAreNamedByFileAndLine) {
  const Folder folder;
  const std::string file = folder.write("a.ini", "Width=64\n\n[x]\nQueue_Memory=lots\n[y]\nShceme=level\n[z]\n+Wx\n");
  EXPECT_TRUE(first_error(parse({"a.pov", file + "[x]"})).starts_with(file + ":4: --queue-memory: expected a size"))
      << first_error(parse({"a.pov", file + "[x]"}));
  const std::string unknown = first_error(parse({"a.pov", file + "[y]"}));
  EXPECT_TRUE(unknown.starts_with(file + ":6: unknown setting 'Shceme=level'")) << unknown;
  EXPECT_NE(unknown.find("the nearest known one is scheme="), std::string::npos) << unknown;
  EXPECT_TRUE(first_error(parse({"a.pov", file + "[z]"})).starts_with(file + ":8: "));
  EXPECT_NE(first_error(parse({"a.pov", file + "[w]"})).find("there are [x], [y], [z]"), std::string::npos);
  EXPECT_NE(first_error(parse({"a.pov", folder / "missing.ini"})).find("missing.ini"), std::string::npos);
}

TEST(IniFile, ABracketThatIsNotClosedIsNotAScene) {
  EXPECT_NE(first_error(parse({"quick.ini[High"})).find("quick.ini[High: there is no such .ini file"),
            std::string::npos);
}

TEST(IniFile, FilesNameOthersButNotForEver) {
  const Folder folder;
  const std::string inner = folder.write("inner.ini", "Width=64\nHeight=x\n");
  const CommandLine line = parse({"a.pov", folder.write("outer.ini", "\n" + inner + "\nabsent.ini\n")});
  EXPECT_EQ(line.options.width, 64);
  ASSERT_EQ(line.errors.size(), 2u);
  EXPECT_TRUE(line.errors[0].starts_with(inner + ":2: ")) << line.errors[0];
  EXPECT_TRUE(line.errors[1].starts_with(folder / "outer.ini" + ":3: absent.ini")) << line.errors[1];

  const std::string self = folder / "self.ini";
  folder.write("self.ini", self + "\n" + self + "\n" + self + "\n" + self + "\n");
  EXPECT_NE(first_error(parse({"a.pov", self})).find("more than 10 deep"), std::string::npos);
}

TEST(IniFile, OnlyTextsOfReasonableSizeAreRead) {
  const Folder folder;
  EXPECT_NE(first_error(parse({"a.pov", folder.write("big.ini", std::string(2 << 20, '\n'))})).find("too large"),
            std::string::npos);
  EXPECT_NE(first_error(parse({"a.pov", folder.write("zeros.ini", std::string(100, '\0'))})).find("not a text file"),
            std::string::npos);
  std::filesystem::create_directory(folder.path / "folder.ini");
  EXPECT_NE(first_error(parse({"a.pov", folder / "folder.ini"})), "");
}

}  // namespace
}  // namespace firstlight::app
