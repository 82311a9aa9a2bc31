#include "app/compare/content.h"
#include "app/compare/list.h"
#include "tests/app/folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

/// a.pov, deep/b.pov, deep/quick.ini and a text.
struct ScenesFolder : Folder {
  ScenesFolder() {
    fs::create_directories(path / "deep");
    write("a.pov", "sphere { 0, 1 }\n");
    write("deep/b.pov", "// compare: share 99.5\n// compare: ini quick.ini[Low] \nbox { 0, 1 }\n");
    write("deep/quick.ini", "[Low]\n+W20\n");
    write("deep/notes.txt", "c.pov");
  }
};

std::vector<std::string> names_of(const SceneList& list) {
  std::vector<std::string> names;
  for (const ListedScene& scene : list.scenes) names.push_back(scene.name);
  return names;
}

TEST(CompareList, AFolderIsSearchedToItsDepth) {
  const ScenesFolder folder;
  const SceneList list = find_scenes(folder.path);
  EXPECT_EQ(list.errors, std::vector<std::string>());
  EXPECT_EQ(names_of(list), (std::vector<std::string>{"a", "deep/b"}));
  EXPECT_TRUE(list.scenes[1].scene.is_absolute());
}

TEST(CompareList, ASceneSaysInCommentsHowItIsCompared) {
  const ScenesFolder folder;
  const SceneList list = find_scenes(folder.path);
  ASSERT_EQ(list.scenes.size(), 2u);
  EXPECT_FALSE(list.scenes[0].share || list.scenes[0].psnr || list.scenes[0].ini);
  EXPECT_EQ(list.scenes[1].share, 99.5);
  ASSERT_TRUE(list.scenes[1].ini);
  EXPECT_EQ(list.scenes[1].ini->filename(), "quick.ini[Low]");
  EXPECT_EQ(list.scenes[1].ini->parent_path(), list.scenes[1].scene.parent_path());
}

TEST(CompareList, AFolderWithoutScenesIsAnError) {
  const Folder folder;
  ASSERT_EQ(find_scenes(folder.path).errors.size(), 1u);
  ASSERT_EQ(find_scenes(folder.path / "gone").errors.size(), 1u);
}

TEST(CompareList, ALineNamesASceneAndWhatItIsRenderedWith) {
  const ScenesFolder folder;
  const SceneList list = parse_list(
      "# a comment\n\na\n  deep/b.pov +A0.3 quick.ini declare=X=1 ; more\n\"a.pov\" +R2\na\n", "list.txt", folder.path);
  EXPECT_EQ(list.errors, std::vector<std::string>());
  EXPECT_EQ(names_of(list), (std::vector<std::string>{"a", "deep/b +A0.3 quick.ini declare=X=1", "a +R2", "a (2)"}))
      << "no two have the same name";
  EXPECT_EQ(list.scenes[1].words, (std::vector<std::string>{"+A0.3", "declare=X=1"}));
  ASSERT_TRUE(list.scenes[1].ini);
  EXPECT_EQ(list.scenes[1].ini->filename(), "quick.ini") << "the list goes before the scene";
}

TEST(CompareList, WhatIsNotThereIsToldWithItsLine) {
  const ScenesFolder folder;
  const SceneList list = parse_list("a\ngone.pov\na none.ini\n", "list.txt", folder.path);
  ASSERT_EQ(list.errors.size(), 2u);
  EXPECT_EQ(list.errors[0].rfind("list.txt:2: there is no scene 'gone.pov'", 0), 0u) << list.errors[0];
  EXPECT_EQ(list.errors[1].rfind("list.txt:3: there is no .ini file", 0), 0u) << list.errors[1];
}

TEST(CompareList, AFileThatIsNoListIsAnError) {
  const ScenesFolder folder;
  folder.write("binary", std::string("a\0b", 3));
  folder.write("empty", "# nothing\n");
  EXPECT_EQ(read_list(folder.path / "none.txt", folder.path).errors.size(), 1u);
  EXPECT_EQ(read_list(folder.path / "binary", folder.path).errors.size(), 1u);
  EXPECT_EQ(read_list(folder.path / "empty", folder.path).errors.size(), 1u);
  EXPECT_EQ(read_list(folder.path / "deep/notes.txt", folder.path / "gone").errors.size(), 1u);
}

class CompareContent : public ::testing::Test {
 protected:
  CompareContent() {
    folder_.write("a.pov", "#include \"part.inc\" // it's 10\" wide\nimage_map { png \"wood.png\" }");
    folder_.write("part.inc", "#include \"deeper.inc\"");
    fs::create_directories(folder_.path / "library");
    folder_.write("library/deeper.inc", "sphere { 0, 1 }");
    folder_.write("wood.png", std::string("\x89PNG\0", 5));
    folder_.write("b.pov", "box { 0, 1 }");
    before_ = key();
  }
  std::string key() const {
    const std::vector<fs::path> libraries{folder_.path / "library"};
    return SceneContent(libraries).of(folder_.path / "a.pov");
  }

  Folder folder_;
  std::string before_;
};

TEST_F(CompareContent, StaysWhenNothingChanges) {
  EXPECT_EQ(key(), before_);
  EXPECT_EQ(before_.size(), 16u);
}

TEST_F(CompareContent, KnowsScenesThatWriteFiles) {
  const auto writes = [&] { return SceneContent({}).writes_files(folder_.path / "a.pov"); };
  EXPECT_FALSE(writes());
  folder_.write("part.inc", "// as #fopen does\n#fopen In \"wood.txt\" read\n#write (Out, \"fopen\")");
  EXPECT_FALSE(writes());
  folder_.write("part.inc", "# fopen Out concat(Name, \".txt\") append");
  EXPECT_TRUE(writes());
}

TEST_F(CompareContent, ChangesWithTheScene) {
  folder_.write("a.pov", "#include \"part.inc\"");
  EXPECT_NE(key(), before_);
}

TEST_F(CompareContent, ChangesWithWhatAnIncludedFileIncludes) {
  folder_.write("library/deeper.inc", "sphere { 0, 2 }");
  EXPECT_NE(key(), before_);
}

TEST_F(CompareContent, ChangesWithAPicture) {
  folder_.write("wood.png", std::string("\x89PNG\1", 5));
  EXPECT_NE(key(), before_);
}

TEST_F(CompareContent, ChangesWithAFileWhoseNameMayBePutTogether) {
  folder_.write("frame3.txt", "3");
  EXPECT_NE(key(), before_);
}

TEST_F(CompareContent, StaysWhenAnotherSceneChanges) {
  folder_.write("b.pov", "box { 0, 2 }");
  EXPECT_EQ(key(), before_);
}

TEST(CompareDigest, PartsAreKeptApart) {
  EXPECT_NE(Digest().add("ab").add("c").text(), Digest().add("a").add("bc").text());
  EXPECT_EQ(Digest().add("ab").text(), Digest().add("ab").text());
}

}  // namespace
}  // namespace firstlight::app::compare
