#include "app/study/options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace firstlight::app {
namespace {

using Words = std::vector<std::string>;

StudyCommandLine parse(const Words& words) { return parse_study_command_line(words); }

std::string only_error(const Words& words) {
  const StudyCommandLine line = parse(words);
  return line.errors.size() == 1 ? line.errors[0] : std::to_string(line.errors.size()) + " errors";
}

TEST(StudyOptions, TakesThePicturesOptionsAndItsOwn) {
  const StudyCommandLine line = parse({"room.pov", "+W64", "+H48", "--out", "here", "--threads", "2", "--rounds=7",
                                       "--schemes", "level; contribution,level ;0.5*level + 0.5*contribution",
                                       "declare=Lights=1", "--queue-memory", "16M", "--every-feeler"});
  ASSERT_EQ(line.errors, Words{});
  const StudyOptions& options = line.options;
  EXPECT_EQ(options.scene.scene, "room.pov");
  EXPECT_EQ(options.scene.width, 64);
  EXPECT_EQ(options.scene.height, 48);
  EXPECT_EQ(options.scene.threads, 2);
  EXPECT_EQ(options.scene.queue_memory, 16u << 20);
  ASSERT_EQ(options.scene.declares.size(), 1u);
  EXPECT_EQ(options.folder, "here");
  EXPECT_EQ(options.rounds, 7);
  EXPECT_TRUE(options.every_feeler);
  EXPECT_EQ(options.schemes, (Words{"level", "contribution,level", "0.5*level + 0.5*contribution"}));
}

TEST(StudyOptions, HasDefaults) {
  const StudyCommandLine line = parse({"scenes/room.pov", "+W64", "+H48"});
  ASSERT_EQ(line.errors, Words{});
  EXPECT_EQ(line.options.folder, "study-room-64x48");
  EXPECT_EQ(line.options.rounds, 3);
  EXPECT_FALSE(line.options.every_feeler);
  EXPECT_TRUE(line.options.schemes.empty());
  EXPECT_EQ(line.options.scene.queue_memory, 0u) << "no limit";
}

TEST(StudyOptions, TheShortFormOfTheFolder) { EXPECT_EQ(parse({"-o", "here", "room.pov"}).options.folder, "here"); }

TEST(StudyOptions, AllSchemesBeginWithTheTraditionalOrder) {
  const Words schemes = all_study_schemes();
  ASSERT_GE(schemes.size(), 5u);
  EXPECT_EQ(schemes.front(), "recursive");
  EXPECT_EQ(std::ranges::count(schemes, "recursive"), 1);
  EXPECT_EQ(std::ranges::count(schemes, "contribution"), 1);
  EXPECT_NE(schemes.back().find('*'), std::string::npos) << "a mixture";
}

TEST(StudyOptions, SaysWhatIsWrong) {
  EXPECT_EQ(only_error({"room.pov", "--rounds", "0"}), "--rounds: expected a number from 1 to 1000, found '0'");
  EXPECT_EQ(only_error({"room.pov", "--rounds", "three"}), "--rounds: expected a number from 1 to 1000, found 'three'");
  EXPECT_EQ(only_error({"room.pov", "--schemes", " ; "}), "--schemes: expected schemes with semicolons between");
  EXPECT_EQ(only_error({"room.pov", "--out="}), "--out: expected a folder");
  EXPECT_EQ(only_error({"room.pov", "--out"}), "option '--out': expected a value after it");
  EXPECT_NE(only_error({"--rounds", "2"}).find("no scene given"), std::string::npos);
  EXPECT_NE(only_error({"room.pov", "--round", "2"}).find("--round"), std::string::npos);
}

TEST(StudyOptions, TheOrderIsItsOwnAffair) {
  EXPECT_EQ(only_error({"room.pov", "--stop-after", "3"}), "study: --stop-after has no meaning here");
  EXPECT_EQ(only_error({"room.pov", "--steer", "-"}), "study: --steer has no meaning here");
  EXPECT_EQ(only_error({"room.pov", "--snapshots", "here"}), "study: --snapshots has no meaning here");
}

TEST(StudyOptions, HelpComesBeforeErrors) {
  const StudyCommandLine line = parse({"--rounds", "0", "--help"});
  EXPECT_EQ(line.wish, StudyCommandLine::Wish::help);
  EXPECT_TRUE(line.errors.empty());
  EXPECT_NE(study_help_text().find("--schemes"), std::string::npos);
}

}  // namespace
}  // namespace firstlight::app
