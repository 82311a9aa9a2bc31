#include "render/scene/object.h"
#include "tests/parser/scene_text.h"

namespace firstlight::parser {
namespace {

using render::Vec3;

TEST(ParseObject, DeclaredObjectStandsAloneOrInABlock) {
  const auto scene =
      scene_of("#declare Ball = sphere { 0, 1 } object { Ball translate 5*x } sphere { Ball translate 9*x } Ball");
  ASSERT_EQ(scene->solids.size(), 3u);
  EXPECT_TRUE(inside(*scene, Vec3(5, 0, 0), 0));
  EXPECT_TRUE(inside(*scene, Vec3(9, 0, 0), 1));
  EXPECT_TRUE(inside(*scene, Vec3(0, 0, 0), 2));
}

TEST(ParseObject, NameOfDeclaredObjectIsKept) {
  const auto scene = scene_of("#declare Ball = sphere { 0, 1 } object { Ball translate 5*x }");
  EXPECT_EQ(scene->objects.at(scene->parts.at(0).object).names, std::vector<std::string>{"Ball"});
}

TEST(ParseObject, NamesAreKeptFromTheOutermostObjectInwards) {
  using Names = std::vector<std::string>;
  const auto scene = scene_of(
      "#declare Leg = cylinder { 0, y, 0.1 } "
      "#declare Chair = union { object { Leg } object { Leg translate x } sphere { y, 1 } } "
      "#declare Throne = object { Chair scale 2 } "
      "object { Throne } object { Chair } Leg sphere { 0, 1 }");
  const auto group = [&](std::size_t part) { return scene->objects.at(scene->parts.at(part).object); };
  EXPECT_EQ(group(0).names, (Names{"Throne", "Chair", "Leg"}));
  EXPECT_EQ(scene->parts[0].object, scene->parts[1].object);
  EXPECT_EQ(group(2).names, (Names{"Throne", "Chair"}));
  EXPECT_EQ(group(2).shape, "sphere");
  EXPECT_EQ(group(3).names, (Names{"Chair", "Leg"}));
  EXPECT_EQ(group(6).names, Names{"Leg"});
  EXPECT_EQ(group(6).shape, "cylinder");
  EXPECT_EQ(group(7).names, Names{});
}

TEST(ParseObject, ALongWayOfNamesIsCutShort) {
  std::string text = "#declare A0 = sphere { 0, 1 }";
  for (int i = 1; i < 30; ++i)
    text += " #declare A" + std::to_string(i) + " = object { A" + std::to_string(i - 1) + " }";
  const auto scene = scene_of(text + " object { A29 }");
  const auto& names = scene->objects.at(scene->parts.at(0).object).names;
  EXPECT_EQ(names.size(), render::ObjectExtras::kMostNames);
  EXPECT_EQ(names.front(), "A29");
}

TEST(ParseObject, LightsKeepTheirNames) {
  using Names = std::vector<std::string>;
  const auto scene = scene_of(
      "#declare Lamp = light_source { y, 1 } #declare Post = union { object { Lamp } sphere { 0, 1 } } "
      "light_source { 0, 1 } object { Post } light_source { Lamp }");
  EXPECT_EQ(scene->light_names, (std::vector<Names>{{}, {"Post", "Lamp"}, {"Lamp"}}));
}

TEST(ParseObject, TransformationsActInReadingOrder) {
  const auto scene = scene_of("sphere { 0, 1 translate 3*x rotate 90*y scale <1, 1, 2> }");
  EXPECT_TRUE(inside(*scene, Vec3(0, 0, -6)));
  EXPECT_FALSE(inside(*scene, Vec3(3, 0, 0)));
}

TEST(ParseObject, ScaleByZeroIsTakenAsOneWithAWarning) {
  const auto result = load("sphere { 0, 1 scale <2, 0, 1> }");
  ASSERT_TRUE(result.scene);
  EXPECT_TRUE(inside(*result.scene, Vec3(1.9, 0, 0)));
  EXPECT_TRUE(inside(*result.scene, Vec3(0, 0.9, 0)));
  EXPECT_NE(warnings(result).find("scale by 0"), std::string::npos);
}

TEST(ParseObject, MatrixHasFourRowsOfThree) {
  const auto scene = scene_of("sphere { 0, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 4, 5, 6> }");
  EXPECT_TRUE(inside(*scene, Vec3(4, 5, 6)));
}

TEST(ParseObject, DeclaredTransformMayBeInverted) {
  const auto scene = scene_of(
      "#declare T = transform { translate 2*x rotate 90*z }"
      "sphere { 0, 1 transform T } sphere { 0, 1 transform { T } transform { T inverse } }"
      "sphere { 0, 1 transform { translate y transform { T inverse } } }");
  EXPECT_TRUE(inside(*scene, Vec3(0, 2, 0), 0));
  EXPECT_TRUE(inside(*scene, Vec3(0, 0, 0), 1));
  EXPECT_TRUE(inside(*scene, Vec3(-1, 0, 0), 2));
}

TEST(ParseObject, SingularMatrixIsAnError) {
  EXPECT_NE(errors(load("sphere { 0, 1 matrix <1,0,0, 1,0,0, 0,1,1, 0,0,0> }")).find("cannot be inverted"),
            std::string::npos);
}

TEST(ParseObject, UnionIsDissolvedIntoItsMembers) {
  const auto scene = scene_of("union { sphere { 0, 1 } box { 1, 2 } union { sphere { 5, 1 } sphere { 7, 1 } } }");
  EXPECT_EQ(scene->solids.size(), 4u);
}

TEST(ParseObject, DifferenceIsWhatIsInTheFirstAndNoOther) {
  const auto scene =
      scene_of("difference { box { -2, 2 } sphere { 0, 1 } union { sphere { 2, 1 } sphere { -2, 1 } } }");
  EXPECT_TRUE(inside(*scene, Vec3(1.5, 0, 0)));
  EXPECT_FALSE(inside(*scene, Vec3(0, 0, 0)));
  EXPECT_FALSE(inside(*scene, Vec3(1.9, 1.9, 1.9)));
  EXPECT_FALSE(inside(*scene, Vec3(-1.9, -1.9, -1.9)));
  EXPECT_FALSE(inside(*scene, Vec3(3, 0, 0)));
}

TEST(ParseObject, InverseTurnsCombinationsInsideOut) {
  const auto scene =
      scene_of("intersection { box { -2, 2 } intersection { sphere { 0, 1 } sphere { 0, 1.5 } inverse } }");
  EXPECT_FALSE(inside(*scene, Vec3(0, 0, 0)));
  EXPECT_TRUE(inside(*scene, Vec3(1.2, 0, 0)));
}

TEST(ParseObject, CombinationOfFewerThanTwoIsAWarning) {
  EXPECT_NE(warnings(load("union { sphere { 0, 1 } }")).find("at least two objects, found one"), std::string::npos);
  const auto empty = load("intersection { } sphere { 0, 1 }");
  ASSERT_TRUE(empty.scene);
  EXPECT_NE(warnings(empty).find("found none"), std::string::npos);
}

TEST(ParseObject, ClipMovesOnlyWithTransformationsBehindIt) {
  // both clips keep what is right of x = 0 in the end
  const auto scene = scene_of(
      "sphere { 0, 1 translate 0 clipped_by { plane { -x, 0 } } }"
      "sphere { <5, 0, 0>, 1 translate -5*x clipped_by { plane { -x, 0 } } }"
      "sphere { <5, 0, 0>, 1 clipped_by { plane { -x, -5 } } translate -5*x }");
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<render::Crossing> found;
    scene->solids.at(i).crossings({Vec3(0.5, 0, -5), Vec3(0, 0, 1)}, 0, found);
    EXPECT_EQ(found.size(), 2u) << i;
    found.clear();
    scene->solids.at(i).crossings({Vec3(-0.5, 0, -5), Vec3(0, 0, 1)}, 0, found);
    EXPECT_EQ(found.size(), 0u) << i;
  }
}

TEST(ParseObject, BoundsAndClipsMayBeOne) {
  const auto scene =
      scene_of("union { sphere { 0, 1 } box { 3, 4 } clipped_by { box { -0.5, 10 } } bounded_by { clipped_by } }");
  ASSERT_EQ(scene->solids.size(), 1u);
  EXPECT_EQ(scene->solids[0].clips().size(), 1u);
  EXPECT_EQ(scene->solids[0].bounds().size(), 1u);
}

TEST(ParseObject, ClipWithATextureIsAnError) {
  EXPECT_NE(errors(load("sphere { 0, 1 clipped_by { box { 0, 1 pigment { rgb 1 } } } }")).find("cannot have a texture"),
            std::string::npos);
  EXPECT_NE(errors(load("sphere { 0, 1 clipped_by { triangle { 0, x, y } } }")).find("must have an inside"),
            std::string::npos);
}

TEST(ParseObject, FlagsTakeAnOptionalNumber) {
  const auto scene = scene_of("sphere { 0, 1 no_shadow no_image off no_reflection hollow double_illuminate }");
  EXPECT_EQ(scene->solids.at(0).hidden_from, render::kHiddenFromShadow | render::kHiddenFromReflection);
  EXPECT_TRUE(scene->parts.at(0).double_illuminate);
}

TEST(ParseObject, WordsThatDoNotChangeThePictureAreTaken) {
  scene_of(
      "union { sphere { 0, 1 } box { 1, 2 } split_union off photons { target reflection on collect off } radiosity { "
      "importance 0.5 } }");
}

TEST(ParseObject, NestingIsLimited) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "union { ";
  EXPECT_NE(errors(load(text)), "");
}

TEST(ParseObject, ObjectsMadeOfObjectsInALoopAreLimited) {
  EXPECT_NE(errors(load("#declare A = sphere { 0, 1 } #for (I, 1, 5000) #declare A = merge { object { A } sphere { I, "
                        "1 } } #end A"))
                .find("nested more than"),
            std::string::npos);
  EXPECT_NE(
      errors(
          load("#declare A = sphere { 0, 1 } #for (I, 1, 60) #declare A = union { object { A } object { A } } #end A"))
          .find("more than"),
      std::string::npos);
}

TEST(ParseObject, NothingOutOfNothingIsLimitedToo) {
  EXPECT_NE(
      errors(load("#declare A = union { } #for (I, 1, 60) #declare A = union { object { A } object { A } } #end A"))
          .find("more than"),
      std::string::npos);
}

TEST(ParseObject, UnsupportedModifierIsNamed) {
  EXPECT_EQ(errors(load("sphere { 0, 1 pigment { pavement } }")),
            "'pavement' cannot be rendered by this version of Firstlight\n");
}

}  // namespace
}  // namespace firstlight::parser
