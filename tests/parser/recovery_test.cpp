#include "parser/directive/interpreter.h"
#include "tests/parser/evaluated.h"

#include <chrono>

namespace firstlight::parser {
namespace {

/// "line:column message" of each error.
std::string places(std::string_view text) {
  std::string all;
  for (const auto& diagnostic : load("\n" + std::string(text)).diagnostics) {
    if (diagnostic.severity != render::Diagnostic::Severity::error) continue;
    all +=
        std::to_string(diagnostic.line - 1) + ":" + std::to_string(diagnostic.column) + " " + diagnostic.message + "\n";
  }
  return all;
}

TEST(Recovery, IndependentMistakesAreAllTold) {
  EXPECT_EQ(places("sphere { 0, 1 pigmint { rgb 1 } }\n"
                   "box { 0 }\n"
                   "sphere { 0, 1 }\n"
                   "#declare A = ;\n"
                   "plane { y, 0 finish { } }\n"
                   "#declare = 4;\n"),
            "1:15 expected '}' to close 'sphere', found undeclared identifier 'pigmint'; did you mean 'pigment'?\n"
            "2:9 expected a numeric expression, found '}'\n"
            "4:14 expected a value, found ';'\n"
            "6:10 expected an identifier after '#declare', found '='\n");
}

TEST(Recovery, WhatFollowsFromAMistakeIsNotTold) {
  EXPECT_EQ(places("#declare Size = 3 * ;\n"
                   "sphere { 0, Size }\n"
                   "sphere { 0, Unknown }\n"
                   "sphere { 1, Unknown }\n"),
            "1:21 expected a numeric expression, found ';'\n"
            "3:13 expected a numeric expression, found undeclared identifier 'Unknown'\n");
}

TEST(Recovery, AnElementThatGotNoValueIsNotTold) {
  EXPECT_EQ(places("#declare A = array[2];\n#declare A[0] = 1 +;\n#declare B = A[0];\nsphere { 0, A[1] }\n"),
            "2:20 expected a numeric expression, found ';'\n");
}

TEST(Recovery, NamesOfAMissingFileAreNotTold) {
  EXPECT_EQ(places("#include \"missing_words.inc\"\nsphere { 0, 1 texture { Missing } }\nsphere { 0 }\n"),
            "1:10 there is no file 'missing_words.inc' in the current folder, the scene's or the library folders\n"
            "3:12 expected a numeric expression, found '}'\n");
}

TEST(Recovery, AMistakeInALoopOrMacroIsToldOnce) {
  EXPECT_EQ(
      places("#for (I, 1, 3)\nsphere { I }\n#end\n#macro Ball()\nsphere { Here }\n#end\nBall()\nBall()\nbox { 0 }\n"),
      "2:12 expected a numeric expression, found '}'\n"
      "5:10 expected a numeric expression, found undeclared identifier 'Here'\n"
      "9:9 expected a numeric expression, found '}'\n");
}

TEST(Recovery, AMistakenConditionTakesItsBlockWithIt) {
  EXPECT_EQ(
      places("#if (1 + )\nsphere { 0, 1 }\n#declare B = 2;\n#else\nbox { }\n#end\nsphere { 0, B }\ntorus { 1 }\n"),
      "1:10 expected a numeric expression, found ')'\n"
      "8:11 expected a numeric expression, found '}'\n");
}

TEST(Recovery, AMissingSemicolonStandsBehindTheValueAndIsAllThatIsWrong) {
  EXPECT_EQ(places("#declare A = 1 + 2\nsphere { 0, A }\n#declare B = rgb 1\n#declare C = 2;"),
            "1:19 expected ';' after the value of 'A', found 'sphere'\n"
            "3:19 expected ';' after the value of 'B', found '#'\n");
}

TEST(Recovery, StopsAfterTwentyMistakes) {
  std::string text;
  for (int i = 0; i < 50; ++i) text += "sphere { " + std::to_string(i) + " }\n";
  const auto result = load(text);
  std::size_t errors = 0;
  for (const auto& diagnostic : result.diagnostics)
    errors += diagnostic.severity == render::Diagnostic::Severity::error;
  EXPECT_EQ(errors, Recovery::kMostMistakes);
  EXPECT_EQ(result.diagnostics.back().message, "reading stops here, after 20 errors");
  EXPECT_EQ(result.scene, nullptr);
}

TEST(Recovery, AnEndWithoutBeginningIsToldWhenNothingElseIsWrong) {
  EXPECT_EQ(places("sphere { 0, 1 }\n#end\n"), "2:2 '#end' without '#if', '#switch', '#while', '#for' or '#macro'\n");
  EXPECT_EQ(places("sphere { 0 }\n}\n#end\n"), "1:12 expected a numeric expression, found '}'\n");
}

TEST(Suggestion, NamesWhatIsLikeAWord) {
  EXPECT_EQ(number("Raduis + 1"),
            "error: expected a value, found undeclared identifier 'Raduis'; did you mean 'radius'?");
  EXPECT_EQ(debugged("#declare Radius = 2; #declare R = 1 + Raduis;"),
            "error: expected a numeric expression, found undeclared identifier 'Raduis'; did you mean 'Radius'?");
  EXPECT_EQ(debugged("#delcare A = 1;"),
            "error: expected a directive after '#', found 'delcare'; did you mean 'declare'?");
}

TEST(Stop, ReadingEndsWhenItIsAskedTo) {
  const SceneFile file("#while (1) #declare A = 1; #end");
  const std::atomic<bool> stop = true;
  render::LoadOptions options;
  options.stop = &stop;
  const auto result = PovFrontEnd().load(file.path(), options);
  EXPECT_EQ(errors(result), "reading the scene was stopped here\n");
}

TEST(Progress, IsToldWhenReadingTakesLong) {
  const SceneFile file("#declare I = 0; #while (now < Until) #declare I = I + 1; #end #error \"end\"");
  render::LoadOptions options;
  // Days since 2000: 1.3 seconds from now.
  const double days =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count() / 86400;
  options.declares = {{"Until", std::to_string(days - 10957.0 + 1.3 / 86400)}};
  render::ParseProgress last;
  options.progress = [&](const render::ParseProgress& progress) { last = progress; };
  PovFrontEnd().load(file.path(), options);
  EXPECT_EQ(last.file, file.path());
  EXPECT_EQ(last.line, 1u);
  EXPECT_GT(last.tokens, 1000u);
}

TEST(Recovery, ANameOfAStandardFileTellsWhichToInclude) {
  EXPECT_NE(debugged("sphere { 0, 1 pigment { color Salmon } }")
                .find("; 'Salmon' is declared in the standard file 'colors.inc', which is not included"),
            std::string::npos);
  EXPECT_NE(debugged("object { Round_Box(-x, x, 0.1, 0) }").find("standard file 'shapes.inc'"), std::string::npos);
  EXPECT_NE(debugged("isosurface { function { f_noise3d(x, y, z) } }").find("standard file 'functions.inc'"),
            std::string::npos);
  EXPECT_EQ(debugged("sphere { 0, 1 pigment { White } }").find("did you mean"), std::string::npos);
  // A part of a name, and one of a file that is included, are none.
  EXPECT_EQ(debugged("sphere { 0, Salmo }").find("standard file"), std::string::npos);
  EXPECT_EQ(debugged("#include \"colors.inc\"\n#undef Salmon\nsphere { 0, Salmon }").find("standard file"),
            std::string::npos);
}

}  // namespace
}  // namespace firstlight::parser
