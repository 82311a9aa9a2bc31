#include "tests/parser/object_text.h"

namespace firstlight::parser {
namespace {

TEST(ParseModifiers, FlagsHaveTheirDefaults) {
  const render::Object object = object_of("sphere { 0, 1 }");
  EXPECT_FALSE(object.uv_mapping || object.cutaway_textures || object.sturm || object.no_radiosity);
  EXPECT_TRUE(object.split_union && object.hierarchy && object.extras->photons.collect);
  EXPECT_FALSE(object.extras->radiosity_importance);
  EXPECT_FALSE(object.extras->photons.reflection || object.extras->photons.refraction ||
               object.extras->photons.pass_through);
  EXPECT_EQ(object.extras->photons.target, 0.0);
}

TEST(ParseModifiers, FlagsAreRead) {
  EXPECT_TRUE(object_of("torus { 1, 0.2 sturm }").sturm);
  EXPECT_FALSE(object_of("torus { 1, 0.2 sturm off }").sturm);
  EXPECT_FALSE(object_of("blob { sphere { 0, 1, 1 } hierarchy off }").hierarchy);
  EXPECT_TRUE(object_of("sphere { 0, 1 no_radiosity }").no_radiosity);
  EXPECT_EQ(object_of("sphere { 0, 1 radiosity { importance 0.5 } }").extras->radiosity_importance, 0.5);
  EXPECT_FALSE(object_of("union { sphere { 0, 1 } sphere { x, 1 } split_union off }").split_union);
  EXPECT_TRUE(object_of("sphere { 0, 1 double_illuminate }").double_illuminate);
}

TEST(ParseModifiers, WordsOfSomeShapesAreRefusedElsewhere) {
  EXPECT_NE(parsed_object("sphere { 0, 1 sturm }").errors.find("does not go with"), std::string::npos);
  EXPECT_NE(parsed_object("torus { 1, 0.2 hierarchy }").errors.find("does not go with"), std::string::npos);
  EXPECT_NE(parsed_object("union { torus { 1, 0.2 } torus { 2, 0.2 } sturm }").errors.find("does not go with"),
            std::string::npos);
  EXPECT_NE(parsed_object("sphere { 0, 1 split_union on }").errors.find("unions only"), std::string::npos);
  EXPECT_NE(parsed_object("sphere { 0, 1 cutaway_textures }").errors.find("only"), std::string::npos);
  EXPECT_NE(parsed_object("sphere { 0, 1 radiosity { importance 2 } }").errors.find("above 0"), std::string::npos);
}

TEST(ParseModifiers, UvMappingStandsBeforeTheTexture) {
  const render::Object object = object_of("sphere { 0, 1 uv_mapping pigment { color rgb 1 } }");
  EXPECT_TRUE(object.uv_mapping);
  EXPECT_EQ(spelled(object.extras->unrendered), "");
  EXPECT_NE(parsed_object("sphere { 0, 1 pigment { color rgb 1 } uv_mapping }").errors.find("before the texture"),
            std::string::npos);
}

TEST(ParseModifiers, CutawayTexturesAreOfIntersections) {
  const render::Object object = object_of("difference { sphere { 0, 1 } sphere { x, 1 } cutaway_textures }");
  EXPECT_TRUE(object.cutaway_textures && object.cuts_away && object.difference);
  EXPECT_TRUE(
      object_of("union { intersection { sphere { 0, 1 } sphere { x, 1 } cutaway_textures } box { 0, 1 } }").cuts_away);
}

TEST(ParseModifiers, PhotonsAreRead) {
  const render::PhotonRole role =
      object_of("sphere { 0, 1 photons { target 0.5 reflection on refraction off collect off } }").extras->photons;
  EXPECT_EQ(role.target, 0.5);
  EXPECT_EQ(role.reflection, true);
  EXPECT_EQ(role.refraction, false);
  EXPECT_FALSE(role.collect);
  EXPECT_EQ(object_of("sphere { 0, 1 photons { target } }").extras->photons.target, 1.0);
  EXPECT_TRUE(object_of("sphere { 0, 1 photons { pass_through } }").extras->photons.pass_through);
}

TEST(ParseModifiers, PhotonsPassThroughOrAreBent) {
  const ParsedObject last = parsed_object("sphere { 0, 1 photons { target pass_through } }");
  EXPECT_NE(last.warnings.find("'refraction' is turned off"), std::string::npos);
  EXPECT_EQ(last.object->extras->photons.refraction, false);
  const ParsedObject first = parsed_object("sphere { 0, 1 photons { pass_through target refraction on } }");
  EXPECT_FALSE(first.object->extras->photons.pass_through);
}

TEST(ParseModifiers, LightGroupIsAUnionWithLightsOfItsOwn) {
  const render::Object group = object_of(
      "light_group { sphere { 0, 1 } light_source { y, rgb 1 } translate x global_lights off photons { target } }");
  EXPECT_EQ(group.kind, render::Object::Kind::union_);
  EXPECT_TRUE(group.extras->light_group);
  EXPECT_FALSE(group.extras->global_lights);
  EXPECT_EQ(group.children->size(), 2u);
  EXPECT_EQ(group.extras->photons.target, 1.0);
  EXPECT_EQ(spelled(group.extras->unrendered), "");
  EXPECT_TRUE(object_of("light_group { sphere { 0, 1 } global_lights }").extras->global_lights);
  EXPECT_NE(parsed_object("light_group { sphere { 0, 1 } pigment { color rgb 1 } }").errors, "");
}

}  // namespace
}  // namespace firstlight::parser
