#include "tests/parser/evaluated.h"

namespace firstlight::parser {
namespace {

std::string errors_within(std::size_t memory, const std::string& text) {
  const SceneFile file("#version 3.7; global_settings { assumed_gamma 1 } camera { }\n" + text);
  render::LoadOptions options;
  options.value_memory = memory;
  return errors(PovFrontEnd().load(file.path(), options));
}

constexpr std::size_t kMemory = 8 << 20;
constexpr const char* kTooLarge = "the strings and arrays of this scene are too large (limit 8 MiB)\n";

TEST(Limit, StringsOfAllNamesTogetherAreBounded) {
  const std::string half = "#declare S = \"0123456789abcdef\"; #for (I, 1, 15) #declare S = concat(S, S); #end\n";
  EXPECT_EQ(errors_within(kMemory, half + "#declare A = array[100]; #for (I, 0, 99) #declare A[I] = S; #end"),
            kTooLarge);
  EXPECT_EQ(errors_within(kMemory, half + "#declare A = array[100]; #for (I, 0, 99) #declare A[1] = S; #end"), "");
}

TEST(Limit, ArraysThatAreCopiedAreBounded) {
  EXPECT_EQ(errors_within(kMemory,
                          "#declare D = dictionary { .A: array[1000] };\n"
                          "#for (I, 1, 18) #declare D[str(I, 0, 0)] = dictionary { .X: D.A, .Y: D.A }; "
                          "#declare D.A = array { D.A, D.A }; #end"),
            kTooLarge);
}

TEST(Limit, UnionsNestAsDeepAsALoopMakesThem) {
  const std::string grow = "#declare A = sphere { 0, 1 } #for (I, 1, 100000) #declare A = ";
  const auto scene = scene_of(grow + "union { object { A } sphere { I, 1 } } #end object { A }");
  EXPECT_EQ(scene->solids.size(), 100'001u);
  const auto cut =
      scene_of(grow + "union { object { A } sphere { I, 1 } } #end difference { box { -1, 1 } object { A } }");
  EXPECT_EQ(cut->solids.size(), 1u);
  EXPECT_EQ(debugged(grow + "union { object { A } sphere { I, 1 } } #end #debug str(max_extent(A).x, 0, 0)\n"
                            "#debug str(inside(A, 50000), 0, 0) #debug str(inside(A, -5), 0, 0)"),
            "10000110");
}

TEST(Limit, WhatElseIsNestedIsRefused) {
  const std::string start = "#declare A = sphere { 0, 1 } #for (I, 1, 100000) #declare A = ";
  for (const std::string text :
       {"difference { object { A } sphere { I, 1 } }", "merge { object { A } sphere { I, 1 } }",
        "sphere { 0, 1 clipped_by { A } }", "light_source { 0, 1 looks_like { object { A } } }",
        "light_source { 0, 1 projected_through { object { A } } }"}) {
    EXPECT_EQ(debugged(start + text + " #end object { A }"), "error: objects are nested more than 1000 deep") << text;
  }
  EXPECT_NE(debugged("#declare P = pigment { rgb 1 } #for (I, 1, 100000) #declare F = function { pigment { P } }\n"
                     "#declare P = pigment { function { F(x, y, z).x } } #undef F #end sphere { 0, 1 pigment { P } }"),
            "");
}

TEST(Limit, UnionsNestAsDeepAsAMacroMakesThem) {
  EXPECT_EQ(debugged("#macro Grow(A, N)\n"
                     "#if (N > 0) Grow(union { union { object { A } sphere { N, 1 } } sphere { -N, 1 } }, N - 1)\n"
                     "#else object { A } #end #end Grow(sphere { 0, 1 }, 900) #debug \"done\""),
            "done");
}

TEST(Limit, AnObjectOfTooManyEndsTheReading) {
  const std::string mistakes = debugged(
      "#declare A = sphere { 0, 1 } #for (I, 1, 40) #declare A = union { object { A } object { A } } #end\n"
      "#declare B = C;");
  EXPECT_EQ(mistakes, "error: object is made of more than 4000000 others");
}

TEST(Limit, ValuesThatAreGoneDoNotCount) {
  EXPECT_EQ(
      errors_within(kMemory, "#macro M() #local A = array[20000]; #declare A[5] = 1; #end #for (I, 1, 100) M() #end"),
      "");
}

TEST(Version, FollowingOnesHaveTheirOwnDefaults) {
  const auto scene_in = [](const std::string& version) {
    const SceneFile file("#version " + version +
                         "; global_settings { assumed_gamma 1 } camera { location -5*z look_at 0 }\n"
                         "sphere { 0, 1 }");
    render::LoadOptions options;
    options.width = 400;
    options.height = 200;
    return std::move(PovFrontEnd().load(file.path(), options).scene);
  };
  const auto old = scene_in("3.7"), following = scene_in("unofficial 3.8");
  ASSERT_TRUE(old && following);
  EXPECT_FLOAT_EQ(finish_of(*old).ambient.x, 0.1f);
  EXPECT_FLOAT_EQ(finish_of(*following).ambient.x, 0.0f);
  EXPECT_FLOAT_EQ(color_of(*following, {}).rgb.x, 1.0f);
  EXPECT_NEAR(old->camera.right.dot(old->camera.right), 1.33 * 1.33, 1e-9);
  EXPECT_NEAR(following->camera.right.dot(following->camera.right), 4.0, 1e-9);
}

TEST(Version, ARangeOfThemIsKnown) {
  EXPECT_EQ(debugged("#version 1.0; #debug str(version, 0, 2)"), "1.00");
  EXPECT_EQ(debugged("#version 3.9;"), "error: expected a version of the language from 1.0 to 3.8, found number 3.9");
}

TEST(Charset, OtherBytesThanAsciiAreBlanksUnlessItSaysWhatTheyMean) {
  EXPECT_EQ(debugged("#debug \"a\xc3\xa4z\""), "a  z");
  EXPECT_EQ(debugged("#version 3.1; #debug \"a\xe4z\""), "a\xc3\xa4z");
  EXPECT_EQ(debugged("global_settings { charset utf8 } #debug concat(\"a\xc3\xa4z\", str(strlen(\"\xc3\xa4\"), 0, 0))"),
            "a\xc3\xa4z1");
  EXPECT_EQ(debugged("global_settings { charset ascii } #debug \"\xc3\xa4\""), "  ");
  EXPECT_EQ(debugged("global_settings { charset sys } #debug \"\xc3\xa4\""), "\xc3\xa4");
}

TEST(StringFunction, ComparesAndReadsNumbersAsPovRayDoes) {
  EXPECT_EQ(number("strcmp(\"ab\", \"a\")", 0), "98");
  EXPECT_EQ(number("strcmp(\"Z\", \"a\")", 0), "-7");
  EXPECT_EQ(number("strcmp(\"a\", \"a\")", 0), "0");
  EXPECT_EQ(number("val(\"0x10\")", 1), "16.0");
  EXPECT_EQ(number("val(\" -2.5e1x\")", 1), "-25.0");
  EXPECT_EQ(number("val(\"--3\")", 1), "0.0");
}

// Going on after it would copy the large array again and again.
TEST(Limit, ReadingEndsWhereArraysAreNestedTooDeeply) {
  const auto result = load(
      "#declare A = array[1] {1}; #declare I = 0; #while (I < 40) #declare A = array[1] {A} #declare I = I + 1; #end "
      "#debug \"behind\"");
  EXPECT_NE(errors(result).find("nested too deeply"), std::string::npos) << errors(result);
  EXPECT_EQ(messages(result, render::Diagnostic::Severity::debug), "");
}

}  // namespace
}  // namespace firstlight::parser
