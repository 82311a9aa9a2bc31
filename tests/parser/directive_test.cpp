#include "tests/parser/evaluated.h"

namespace firstlight::parser {
namespace {

TEST(Declare, NeedsASemicolonBehindNumbers) {
  EXPECT_EQ(debugged("#declare A = 5\nsphere { 0, A }"), "error: expected ';' after the value of 'A', found 'sphere'");
}
TEST(Declare, ATextureNeedsNoSemicolon) {
  EXPECT_EQ(debugged("#declare T = texture { pigment { rgb 1 } }\n#declare U = texture { T }\n#debug \"both\""),
            "both");
}
TEST(Declare, TheNameMayStandRightBehindItsDeclaration) {
  EXPECT_EQ(debugged("#declare Ball = sphere { 0, 1 } Ball #debug \"read\""), "read");
}
TEST(Declare, TheNextDirectiveWaitsForTheValue) {
  EXPECT_EQ(debugged("#declare A = 1; #declare A = A + 1; #debug str(A, 0, 0)"), "2");
}
TEST(Declare, AReservedWordIsNoIdentifier) {
  EXPECT_EQ(debugged("#declare sphere = 1;"),
            "error: expected an identifier after '#declare', found the reserved word 'sphere'");
}
TEST(Declare, AnUndeclaredValueIsNamed) {
  EXPECT_EQ(debugged("#declare A = Nope;"), "error: expected a value, found undeclared identifier 'Nope'");
}
TEST(Declare, WithoutTheHashItWarns) {
  const auto result = load("declare A = 5; sphere { 0, A }");
  EXPECT_EQ(messages(result, render::Diagnostic::Severity::warning), "'declare' should be written '#declare'\n");
}
TEST(Undef, RemovesAName) {
  EXPECT_EQ(debugged("#declare A = 1; #undef A #ifdef (A) #debug \"yes\" #else #debug \"no\" #end"), "no");
}
TEST(Undef, AnUnknownNameWarns) {
  EXPECT_EQ(messages(load("#undef Nope\nsphere { 0, 1 }"), render::Diagnostic::Severity::warning),
            "'Nope' is not declared, so '#undef' changes nothing\n");
}

TEST(If, TakesOneBranch) {
  EXPECT_EQ(debugged("#if (0) #debug \"a\" #elseif (1) #debug \"b\" #else #debug \"c\" #end"), "b");
  EXPECT_EQ(debugged("#if (0) #if (1) #debug \"a\" #else #debug \"b\" #end #else #debug \"c\" #end"), "c");
}
TEST(If, AnElseWithoutIfIsAnError) { EXPECT_EQ(debugged("#else"), "error: '#else' without '#if'"); }
TEST(If, AnEndWithoutIfIsAnError) {
  EXPECT_EQ(debugged("#end"), "error: '#end' without '#if', '#switch', '#while', '#for' or '#macro'");
}
TEST(Ifdef, KnowsArrayElements) {
  EXPECT_EQ(
      debugged(
          "#declare A = array[2]; #declare A[0] = 1; #ifdef (A[0]) #debug \"0\" #end #ifdef (A[1]) #debug \"1\" #end"),
      "0");
}
TEST(Switch, CasesFallThroughWithoutBreak) {
  const std::string body =
      "#switch (X) #case (1) #debug \"one \" #break #case (2) #debug \"two \" #case (3) #debug \"three \" #break "
      "#range (5, 7) #debug \"range \" #break #else #debug \"else \" #end ";
  EXPECT_EQ(debugged("#for (X, 1, 7, 1.5) " + body + "#end"), "one else else range range ");
  EXPECT_EQ(debugged("#declare X = 2; " + body), "two three ");
}
TEST(Switch, ACaseMustFollow) {
  EXPECT_EQ(debugged("#switch (1) sphere { 0, 1 } #case (1) #end"),
            "error: expected '#case' or '#range' after '#switch', found 'sphere'");
}
TEST(While, TurnsUntilFalse) {
  EXPECT_EQ(debugged("#declare I = 0; #while (I < 3) #debug str(I, 0, 0) #declare I = I + 1; #end"), "012");
}
TEST(While, BreakLeavesTheInnermost) {
  EXPECT_EQ(
      debugged(
          "#declare I = 0; #while (I < 2) #declare J = 0; #while (1) #if (J = 2) #break #end #declare J = J + 1; #end "
          "#debug str(J, 0, 0) #declare I = I + 1; #end"),
      "22");
}
TEST(While, MayEmitPartsOfAStatement) {
  const auto result = load("union { #declare I = 0; #while (I < 3) sphere { I*x, 0.4 } #declare I = I + 1; #end }");
  ASSERT_EQ(errors(result), "");
  EXPECT_EQ(result.scene->parts.size(), 3u);
}
TEST(For, CountsBothWays) {
  EXPECT_EQ(
      debugged(
          "#for (I, 1, 2, 0.25) #debug concat(str(I, 0, 2), \" \") #end #for (I, 3, 1, -1) #debug str(I, 0, 0) #end"),
      "1.00 1.25 1.50 1.75 2.00 321");
}
TEST(For, MayNotTurnAtAll) { EXPECT_EQ(debugged("#for (I, 2, 1) #debug \"x\" #end #debug \"end\""), "end"); }
TEST(For, AStepOfZeroIsAnError) {
  EXPECT_EQ(debugged("#for (I, 1, 2, 0) #end"), "error: expected a step that is not 0 for '#for', found number 0");
}

TEST(Message, ErrorStopsTheScene) {
  EXPECT_EQ(debugged("#error concat(\"no \", \"way\")"), "error: stopped by '#error': no way");
}
TEST(Message, WarningGoesOn) {
  EXPECT_EQ(messages(load("#warning \"careful\" sphere { 0, 1 }"), render::Diagnostic::Severity::warning), "careful\n");
}
TEST(Message, WarningEndsItsLineItself) {
  EXPECT_EQ(messages(load("#warning \"careful\\n\" sphere { 0, 1 }"), render::Diagnostic::Severity::warning),
            "careful\n");
}
TEST(Message, RenderAndStatisticsGoWhereDebugGoes) {
  const auto result = load("#render \"r\\n\" #statistics \"s\" sphere { 0, 1 }");
  EXPECT_EQ(messages(result, render::Diagnostic::Severity::debug), "r\n\ns\n");
  EXPECT_EQ(warnings(result), "'#render' writes where '#debug' does\n'#statistics' writes where '#debug' does\n");
}
TEST(Declare, ADeprecatedNameWarnsWhenItIsUsed) {
  EXPECT_EQ(warnings(load("#declare deprecated once \"old one\" A = 1; #declare deprecated B = 1;\n"
                          "sphere { 0, A + A + B + B }")),
            "old one\n'B' is deprecated\n'B' is deprecated\n");
}
TEST(Directive, AnUndeclaredNameMayBeUndefined) {
  EXPECT_EQ(warnings(load("#undef Nothing sphere { 0, 1 }")),
            "'Nothing' is not declared, so '#undef' changes nothing\n");
}
TEST(Directive, AChoiceMayEndInTheFileThatIncludesIt) {
  const SceneFile open("#if (1) #debug \"a\""), closed("#if (0) #debug \"b\" #else"),
      middle("#debug \"x\" #else #debug \"y\"");
  EXPECT_EQ(debugged("#include \"" + open.path() + "\" #debug \"c\" #else #debug \"d\" #end #debug \"e\""), "ace");
  EXPECT_EQ(debugged("#include \"" + closed.path() + "\" #debug \"c\" #end #debug \"e\""), "ce");
  EXPECT_EQ(debugged("#if (1) #include \"" + middle.path() + "\" #debug \"z\" #end #debug \"e\""), "xe");
}
TEST(Directive, AMisspeltOneIsAnError) {
  EXPECT_EQ(debugged("#delcare A = 1;"),
            "error: expected a directive after '#', found 'delcare'; did you mean 'declare'?");
}

TEST(Array, KeepsItsValues) {
  EXPECT_EQ(debugged("#declare A = array[2][2] {{1, 2}, {3, 4}} #declare A[0][1] = 7; "
                     "#debug str(A[0][1] + A[1][0]*10 + dimensions(A)*100 + dimension_size(A, 2)*1000, 0, 0)"),
            "2237");
}
TEST(Array, IsCopiedWhenDeclared) {
  EXPECT_EQ(debugged("#declare A = array[1] {5} #declare B = A; #declare B[0] = 6; #debug str(A[0], 0, 0)"), "5");
}
TEST(Array, HoldsArrays) {
  EXPECT_EQ(debugged("#declare A = array[2] {array[2] {1, 2}, array[1] {3}} #debug str(A[0][1]*10 + A[1][0], 0, 0)"),
            "23");
}
TEST(Array, ASubscriptOutsideIsAnError) {
  EXPECT_EQ(debugged("#declare A = array[2] {1, 2} #debug str(A[2], 0, 0)"),
            "error: expected a subscript from 0 to 1 for 'A', found 2");
}
TEST(Array, AnEmptyElementIsAnError) {
  EXPECT_EQ(debugged("#declare A = array[2]; #debug str(A[1], 0, 0)"), "error: this element of 'A' has no value yet");
}
TEST(Array, ElementsAreOfOneKind) {
  EXPECT_EQ(debugged("#declare A = array[2]; #declare A[0] = 1; #declare A[1] = \"s\";"),
            "error: expected a value of the same kind as the array's other elements, found a string");
}
TEST(Array, TooFewValuesAreAnError) {
  EXPECT_EQ(debugged("#declare A = array[3] {1, 2}"), "error: expected 3 values for the array, found 2");
}

}  // namespace
}  // namespace firstlight::parser
