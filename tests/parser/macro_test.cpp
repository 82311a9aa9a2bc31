#include "tests/parser/evaluated.h"

namespace firstlight::parser {
namespace {

TEST(Macro, GivesAValue) {
  EXPECT_EQ(debugged("#macro F(A, B) A*10 + B #end #declare R = F(1, 2)*2; #debug str(R, 0, 0)"), "14");
}
TEST(Macro, GivesPartsOfAStatement) {
  const auto result = load("#macro Body(R) { 0, R #end sphere Body(2) pigment { rgb 1 } }");
  EXPECT_EQ(errors(result), "");
}
TEST(Macro, ChangesItsCallersName) {
  EXPECT_EQ(debugged("#macro Inc(V) #declare V = V + 1; #end #declare Q = 5; Inc(Q) #debug str(Q, 0, 0)"), "6");
  EXPECT_EQ(
      debugged("#macro Inc(V) #declare V = V + 1; #end #declare A = array[1] {5} Inc(A[0]) #debug str(A[0], 0, 0)"),
      "6");
}
TEST(Macro, ChangesItsCallersObject) {
  const auto result = load(
      "#macro Turn(Stuff) #declare Stuff = object { Stuff translate x } #end #declare S = sphere { 0, 1 } Turn(S) S");
  ASSERT_EQ(errors(result), "");
  EXPECT_EQ(result.scene->parts.size(), 1u);
}
TEST(Macro, AnExpressionIsHandedOverByValue) {
  EXPECT_EQ(debugged("#macro Inc(V) #declare V = V + 1; #end #declare Q = 5; Inc(Q + 0) #debug str(Q, 0, 0)"), "5");
}
TEST(Macro, LocalNamesEndWithIt) {
  EXPECT_EQ(debugged("#declare L = 4; #macro F() #local L = 9; L #end #declare R = F()*10 + L; #debug str(R, 0, 0)"),
            "94");
}
TEST(Macro, SeesTheNamesOfItsCaller) {
  EXPECT_EQ(
      debugged(
          "#macro Inner() Outer #end #macro F() #local Outer = 42; Inner() #end #declare R = F(); #debug str(R, 0, 0)"),
      "42");
}
TEST(Macro, CallsItself) {
  EXPECT_EQ(debugged("#macro Fact(N) #if (N <= 1) #local R = 1; #else #local R = N*Fact(N - 1); #end R #end "
                     "#declare Result = Fact(6); #debug str(Result, 0, 0)"),
            "720");
}
TEST(Macro, MayBeItsOwnArgument) {
  EXPECT_EQ(debugged("#macro F(A) (A + 1) #end #declare R = F(F(F(1))); #debug str(R, 0, 0)"), "4");
}
TEST(Macro, BreakLeavesIt) { EXPECT_EQ(debugged("#macro F(A) #if (A) #break #end #debug \"x\" #end F(1) F(0)"), "x"); }
TEST(Macro, CanBeDefinedAgain) {
  EXPECT_EQ(debugged("#macro F() 1 #end #macro F() 2 #end #declare R = F(); #debug str(R, 0, 0)"), "2");
}
TEST(Macro, ABodyThatIsNeverCalledIsNotRead) {
  EXPECT_EQ(debugged("#macro F() sphere { nonsense #end #debug \"fine\""), "fine");
}
TEST(Macro, TooFewArgumentsAreAnError) {
  EXPECT_EQ(debugged("#macro F(A, B) #end F(1)"), "error: expected 2 arguments for the macro 'F', found 1");
}
TEST(Macro, AnUndeclaredArgumentIsNamed) {
  EXPECT_EQ(debugged("#macro F(A) #end F(Nope)"), "error: expected a value, found undeclared identifier 'Nope'");
}
TEST(Macro, AnErrorInsideTellsOfTheCall) {
  const auto result = load("#macro Column(R) sphere { 0, R*<1, 2, 3> } #end\nColumn(2)");
  ASSERT_GE(result.diagnostics.size(), 2u);
  const auto& note = result.diagnostics.back();
  EXPECT_EQ(note.severity, render::Diagnostic::Severity::note);
  EXPECT_EQ(note.message, "in macro 'Column', called from here");
  EXPECT_EQ(note.line, 2u);
}

TEST(Limit, EndlessRecursionIsAnError) {
  EXPECT_EQ(debugged("#macro F() F() #end F()"),
            "error: macros and included files are nested too deeply here (limit 1000)");
}
TEST(Limit, DeepParenthesesAreAnError) {
  const std::string deep(5000, '(');
  EXPECT_NE(number(deep).find("nested too deeply here (limit 250)"), std::string::npos);
}
TEST(Limit, DeepBlocksAreAnError) {
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "union {";
  EXPECT_EQ(debugged(deep), "error: blocks are nested too deeply here (limit 200)");
}
TEST(Limit, DeepDeclarationsAreAnError) {
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "#declare A = union { ";
  EXPECT_NE(debugged(deep).find("nested too deeply here"), std::string::npos);
}
TEST(Limit, DeepSubscriptsAreAnError) {
  std::string deep = "#declare A = array[1] {0} #declare R = ";
  for (int i = 0; i < 5000; ++i) deep += "A[";
  EXPECT_NE(debugged(deep).find("nested too deeply here"), std::string::npos);
}
TEST(Limit, DeepArgumentsAreAnError) {
  std::string deep = "#macro F(A) A #end #declare R = ";
  for (int i = 0; i < 5000; ++i) deep += "F(";
  EXPECT_NE(debugged(deep).find("nested too deeply here"), std::string::npos);
}
TEST(Limit, AHugeArrayIsAnError) {
  EXPECT_EQ(debugged("#declare A = array[100000][100000]"), "error: the array is too large (limit 16777216 elements)");
}
TEST(Limit, AGrowingStringIsAnError) {
  EXPECT_EQ(debugged("#declare S = \"0123456789\"; #while (1) #declare S = concat(S, S); #end"),
            "error: the string is too long (limit 1048576 bytes)");
}
TEST(Limit, ArraysInArraysAreBounded) {
  EXPECT_EQ(debugged("#declare A = array[1] {1} #while (1) #declare A = array[1] {A} #end"),
            "error: arrays and dictionaries are nested too deeply here (limit 20)");
}

}  // namespace
}  // namespace firstlight::parser
