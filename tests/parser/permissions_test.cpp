#include "parser/text/permissions.h"

#include <gtest/gtest.h>

namespace firstlight::parser {
namespace {

const Permissions::Places kPlaces{"/usr/share/povray-3.7", "/home/anna", "/home/anna/scenes"};

Permissions read(std::string_view text) {
  std::vector<std::string> problems;
  Permissions result = Permissions::parse(text, kPlaces, problems);
  EXPECT_TRUE(problems.empty()) << problems.front();
  return result;
}

TEST(Permissions, FoldersHoldWithWhatIsBelowOnlyWithAStar) {
  const Permissions permissions = read("[Permitted Paths]\nread = /opt/a\nread* = /opt/b\nread+write* = /opt/c\n");
  EXPECT_TRUE(permissions.may_read("/opt/a/file"));
  EXPECT_FALSE(permissions.may_read("/opt/a/below/file"));
  EXPECT_TRUE(permissions.may_read("/opt/b/below/file"));
  EXPECT_FALSE(permissions.may_write("/opt/b/file"));
  EXPECT_TRUE(permissions.may_write("/opt/c/below/file"));
  EXPECT_TRUE(permissions.may_read("/opt/c/below/file"));
  EXPECT_FALSE(permissions.may_read("/opt/cc/file"));
}

TEST(Permissions, PlacesHaveNames) {
  const Permissions permissions = read(
      "; a comment\n[Permitted Paths]\nread* = %INSTALLDIR%/include ; the standard ones\n"
      "read=\"%HOME%/my scenes\"\nread+write = .\nread* = %CWD%/parts\n");
  EXPECT_TRUE(permissions.may_read("/usr/share/povray-3.7/include/colors.inc"));
  EXPECT_TRUE(permissions.may_read("/home/anna/my scenes/a.pov"));
  EXPECT_TRUE(permissions.may_write("/home/anna/scenes/out.txt"));
  EXPECT_FALSE(permissions.may_write("/home/anna/scenes/below/out.txt"));
  EXPECT_TRUE(permissions.may_read("/home/anna/scenes/parts/x.inc"));
}

TEST(Permissions, SecurityLevelsFreeReadingOrAll) {
  const Permissions free = read("[File I/O Security]\nnone\n");
  EXPECT_TRUE(free.may_read("/any/file") && free.may_write("/any/file"));
  const Permissions reading = read("[File I/O Security]\nread-only ; comment\n[Permitted Paths]\nread+write = /opt\n");
  EXPECT_TRUE(reading.may_read("/any/file") && reading.may_write("/opt/file"));
  EXPECT_FALSE(reading.may_write("/any/file"));
}

TEST(Permissions, TheInstalledSyntaxIsUnderstood) {
  const Permissions permissions = read(
      "[File I/O Security]\n;none\nrestricted\n[Shellout Security]\nforbidden\n[Permitted Paths]\nread* = "
      "/etc/povray\n");
  EXPECT_TRUE(permissions.may_read("/etc/povray/3.7/povray.conf"));
  EXPECT_FALSE(permissions.may_read("/etc/passwd"));
}

TEST(Permissions, WhatHasNoMeaningIsNamed) {
  std::vector<std::string> problems;
  Permissions::parse("[Permitted Paths]\nreed = /opt\n[Nothing]\n", kPlaces, problems);
  EXPECT_EQ(problems, (std::vector<std::string>{"line 2: 'reed = /opt' has no meaning here",
                                                "line 3: '[Nothing]' has no meaning here"}));
}

TEST(Permissions, BuiltInOnesWriteInTheWorkingFolderAndBelow) {
  const Permissions permissions = Permissions::built_in(kPlaces);
  EXPECT_TRUE(permissions.may_write("/home/anna/scenes/below/out.txt"));
  EXPECT_FALSE(permissions.may_write("/home/anna/out.txt"));
  EXPECT_TRUE(permissions.may_read("/home/anna/scenes/below/x.inc"));
  EXPECT_FALSE(permissions.may_read("/home/anna/other/x.inc"));
  EXPECT_FALSE(permissions.may_read("/tmp/x.inc"));
  EXPECT_FALSE(permissions.may_read("/etc/passwd"));
}

TEST(Permissions, BuiltInOnesLeaveHiddenFilesAlone) {
  const Permissions permissions = Permissions::built_in(kPlaces);
  EXPECT_FALSE(permissions.may_read("/home/anna/scenes/.ssh/id"));
  EXPECT_FALSE(permissions.may_write("/home/anna/scenes/.profile"));
  EXPECT_FALSE(permissions.may_read("/home/anna/scenes/a/.b/c"));
}

TEST(Permissions, TheRootFolderPermitsNothingBelow) {
  const Permissions permissions = Permissions::built_in({kPlaces.install, "", "/"});
  EXPECT_FALSE(permissions.may_read("/etc/passwd"));
  EXPECT_FALSE(permissions.may_write("/etc/passwd"));
  std::vector<std::string> problems;
  const Permissions home =
      Permissions::parse("[Permitted Paths]\nread* = %HOME%\n", {kPlaces.install, "", "/opt"}, problems);
  EXPECT_FALSE(home.may_read("/etc/passwd"));
}

TEST(Permissions, ReachIsSeenByTheWordsOfAPath) {
  const Permissions permissions = Permissions::built_in(kPlaces);
  EXPECT_TRUE(permissions.may_reach("/home/anna/scenes/parts/../x.inc"));
  EXPECT_TRUE(permissions.may_reach("/home/anna/scenes/x.inc"));
  EXPECT_FALSE(permissions.may_reach("/home/anna/scenes/../other/x.inc"));
  EXPECT_FALSE(permissions.may_reach("/home/anna/scenes/../other/../scenes/x.inc"));
  EXPECT_FALSE(permissions.may_reach("/etc/passwd"));
}

}  // namespace
}  // namespace firstlight::parser
