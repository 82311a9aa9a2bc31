// Reserved words that have no meaning of their own in version 3.7, and words in a second spelling.

#include "tests/parser/scene_text.h"

#include <gtest/gtest.h>

#include <string>

namespace firstlight::parser {
namespace {

TEST(ReservedWord, WithoutAMeaningIsNoName) {
  for (const std::string word : {"alpha", "composite", "distance_maximum", "dtag", "global", "steps"}) {
    const auto result = load("#declare " + word + " = 1;");
    EXPECT_FALSE(result.scene) << word;
    EXPECT_NE(errors(result).find("'" + word + "'"), std::string::npos) << errors(result);
  }
}

TEST(ReservedWord, InItsOtherSpellingIsTheSame) {
  const auto result = load(
      "sphere { 0, 1 pigment { colour rgb 1 quick_colour rgb <1, 0, 0> } } "
      "camera { location -5 * z }");
  EXPECT_TRUE(result.scene) << errors(result);
}

TEST(ReservedWord, CompositeIsAUnion) {
  const auto result = load("intersection { composite { sphere { 0, 1 } sphere { 3, 1 } } box { -1, 2.5 } }");
  ASSERT_TRUE(result.scene) << errors(result);
  EXPECT_EQ(warnings(result), "'composite' is an old word for 'union'\n");
  EXPECT_TRUE(inside(*result.scene, {0.0, 0.0, 0.5}));
  EXPECT_TRUE(inside(*result.scene, {2.45, 2.45, 2.45}));
  EXPECT_FALSE(inside(*result.scene, {1.5, 1.5, 1.5}));
}

}  // namespace
}  // namespace firstlight::parser
