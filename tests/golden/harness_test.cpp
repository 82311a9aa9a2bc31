// The list of scenes and what they say of themselves.

#include "render/texture/pattern_kind.h"
#include "tests/golden/run.h"
#include "tests/golden/scene_list.h"

#include <gtest/gtest.h>

#include <set>

namespace firstlight::golden {
namespace {

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

TEST(Patterns, EachThatIsRenderedHasASceneOfItsName) {
  using render::PatternKind;
  for (int i = static_cast<int>(PatternKind::plain) + 1; i <= static_cast<int>(PatternKind::wrinkles); ++i) {
    const auto kind = static_cast<PatternKind>(i);
    if (!render::is_rendered(render::feature_of(kind))) continue;
    const std::string word(render::spelling(kind));
    EXPECT_TRUE(std::filesystem::exists(testscenes() / "patterns" / (word + ".pov"))) << word;
  }
}

}  // namespace
}  // namespace firstlight::golden
