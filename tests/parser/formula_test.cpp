// Text that is replayed is evaluated by formulas; that must not show.
#include "parser/expression/formula.h"
#include "parser/text/token_file.h"
#include "tests/parser/agreement_table.h"
#include "tests/parser/evaluated.h"

#include <cctype>
#include <string>
#include <vector>

namespace firstlight::parser {
namespace {

/// Whether `text`, with something behind it, has a formula that reaches to the ';'.
bool has_formula(const std::string& text, Formula::Kind kind = Formula::Kind::sum) {
  Symbols symbols;
  SourceFile source;
  source.text = text + "; ";
  source.line_starts = {0};
  const TokenFile file(source, symbols);
  const auto formula = Formula::compile(file, 0, kind);
  return formula != nullptr && file[formula->end()].is(Punctuation::semicolon);
}

TEST(Formula, StandsForNumbersAndVectors) {
  EXPECT_TRUE(has_formula("A*-2 + sin(B/2) - max(1, C, pi)"));
  EXPECT_TRUE(has_formula("vcross(<A, 2>*x, B).y + !C"));
  EXPECT_TRUE(has_formula("(A < B & C != 2)*3"));
  EXPECT_TRUE(has_formula("A < B", Formula::Kind::full));
}
TEST(Formula, HasNoCallsElementsOrStrings) {
  EXPECT_FALSE(has_formula("F(1) + 2"));
  EXPECT_FALSE(has_formula("2*A[1]"));
  EXPECT_FALSE(has_formula("strlen(\"abc\")"));
  EXPECT_FALSE(has_formula("(A ? 1 : 2)"));
}
TEST(Formula, HasNoMistakes) {
  for (const char* text :
       {"1 +", "<1>", "<1, 2, 3, 4, 5, 6>", "<1, 2, 3, 4, 5,>", "A.b", "A.x.y", "(1", "sin 1", "*"}) {
    EXPECT_FALSE(has_formula(text)) << text;
  }
}
TEST(Formula, IsBounded) {
  EXPECT_FALSE(has_formula(std::string(5000, '-') + "1"));
  EXPECT_FALSE(has_formula(std::string(5000, '(') + "1" + std::string(5000, ')')));
  EXPECT_FALSE(has_formula("0 + A1*(1 + A2*(1 + A3*(1 + A4*(1 + A5*(1 + A6*(1 + A7*(1 + A8*(1 + A9*2))))))))"));
  std::string names = "N";
  for (int i = 0; i < 20; ++i) names += " + N" + std::to_string(i);
  EXPECT_FALSE(has_formula(names));
}
TEST(Formula, IsMadeWhenTextIsMetAgain) {
  Symbols symbols;
  SourceFile source;
  source.text = "1 + 2;";
  source.line_starts = {0};
  const TokenFile file(source, symbols);
  FormulaTable formulas;
  EXPECT_EQ(formulas.find(file, 0, Formula::Kind::sum), nullptr);
  const Formula* const formula = formulas.find(file, 0, Formula::Kind::sum);
  ASSERT_NE(formula, nullptr);
  EXPECT_EQ(formulas.find(file, 0, Formula::Kind::sum), formula);
  EXPECT_EQ(formulas.find(file, 0, Formula::Kind::full), nullptr);
}

/// The expression in all places that formulas serve: declared, as a condition, handed to a macro, as an argument.
std::string everywhere(const std::string& line) {
  const std::string value = line.substr(2);
  if (line[0] == '"') return "#debug concat(\"~\", " + value + ")\n";
  const std::string count(1, line[0] == '=' ? '1' : line[0]);
  std::string text = "#declare Value = " + value + ";\nShow" + count + "(Value) Show" + count + "(" + value + ")\n";
  if (line[0] == '=') {
    text += "#if (" + value + ") #debug \"true\" #end #debug str(" + value + ", 0, 17) Show1(abs(" + value + "))\n";
    text += "Show3(<" + value + ", 2, 3>*2)\n";
  }
  if (line[0] <= '3') text += "Show3(vcross(" + value + ", <1, 2, 3>)) Show3(<4, 5, 6>*(" + value + ") + 1)\n";
  return "#undef Value " + text;
}

TEST(Formula, RepeatedTextHasTheValuesOfTextThatIsReadOnce) {
  std::string straight = "#macro Show1(V) #debug concat(\" \", str(V, 0, 17)) #end\n";
  for (const char* count : {"2", "3", "4", "5"}) {
    straight +=
        std::string("#macro Show") + count + "(V) #debug concat(\" \", vstr(" + count + ", V, \" \", 0, 17)) #end\n";
  }
  std::string repeated = straight;
  std::ifstream file(std::string(FIRSTLIGHT_SOURCE_DIR) + "/tests/parser/agreement.txt");
  std::size_t count = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '/') continue;
    if (line[0] == '#') {
      straight += line + "\n";
      repeated += line + "\n";
      continue;
    }
    const std::string text = everywhere(line);
    for (int i = 0; i < 4; ++i) straight += text;
    repeated += "#for (Turn, 1, 4) " + text + "#end\n";
    ++count;
  }
  ASSERT_GE(count, 400u);
  const auto once = load(straight), again = load(repeated);
  EXPECT_EQ(errors(once), "");
  EXPECT_EQ(errors(again), "");
  EXPECT_EQ(warnings(again), warnings(once));
  EXPECT_EQ(messages(again, render::Diagnostic::Severity::debug), messages(once, render::Diagnostic::Severity::debug));
}

TEST(Formula, ANameMayChangeItsKindFromTurnToTurn) {
  const std::string loop =
      "#declare A = 1; #for (I, 1, 6) #if (I = 4) #declare A = <1, 2, 3>; #end #if (I = 6) #declare A = \"a\"; #end "
      "#declare B = 1 + A*2; #debug vstr(3, B*<1, 1, 1>, \" \", 0, 0) #end";
  EXPECT_EQ(debugged(loop), "error: expected a numeric expression, found string 'A'");
  // The last turn's declaration fails and leaves B as it was.
  EXPECT_EQ(messages(load(loop), render::Diagnostic::Severity::debug), "3 3 3\n3 3 3\n3 3 3\n3 5 7\n3 5 7\n3 5 7\n");
  EXPECT_EQ(debugged("#macro M(X) #debug str((X = \"a\") + (X < \"b\")*10, 0, 0) #end M(\"a\") M(\"b\") M(\"a\")"),
            "11011");
}
TEST(Formula, ANameMayChangeItsSizeFromTurnToTurn) {
  const std::string values = "array mixed [6] { 2, <1, 2>, <1, 2, 3>, <1, 2, 3, 4>, rgb <1, 2, 3>, <1, 2, 3, 4, 5> }";
  const std::string loop = "#declare Values = " + values +
                           "; #for (Turn, 0, 2) #for (I, 0, 5) #declare A = Values[I]; "
                           "#debug concat(\" \", vstr(5, 1 + A*2, \",\", 0, 0)) "
                           "#debug concat(\" \", vstr(3, <A.x, 2, 3>*A, \",\", 0, 0)) #end #end";
  const std::string turn =
      " 5,0,0,0,0 4,4,6 3,5,0,0,0 1,4,0 3,5,7,0,0 1,4,9 3,5,7,9,0 1,4,9 3,5,7,1,1 1,4,9 3,5,7,9,11 1,4,9";
  EXPECT_EQ(debugged(loop), turn + turn + turn);
}
TEST(Formula, WhatIsDeclaredInOneTurnIsUsedInTheNext) {
  EXPECT_EQ(debugged("#declare A = 1; #while (A < 100) #declare A = A*2; #end #debug str(A, 0, 0)"), "128");
  EXPECT_EQ(
      debugged("#macro F(N) #local R = 1; #if (N > 1) #local R = N*F(N - 1); #end R #end #debug str(F(10), 0, 0)"),
      "3628800");
}
TEST(Formula, ALocalNameHasNoValueInItsOwnDeclaration) {
  EXPECT_EQ(debugged("#declare A = 5; #macro M(Own) #if (Own) #local A = 0; #end #local A = A + 1; #end "
                     "M(1) M(1) M(1) #debug str(A, 0, 0)"),
            "5");
  EXPECT_EQ(debugged("#declare A = 5; #macro M(Own) #if (Own) #local A = 0; #end #local A = A + 1; #end "
                     "M(1) M(1) M(1) M(0)"),
            "error: expected a value, found undeclared identifier 'A'");
}
TEST(Formula, AMacroCannotBeDeclaredAsANumber) {
  EXPECT_EQ(debugged("#macro M() #end #for (I, 1, 4) #if (I < 4) #undef M #end #declare M = I + 1; "
                     "#if (I = 3) #undef M #macro M() #end #end #end"),
            "error: expected an identifier after '#declare', found the macro 'M'");
}
TEST(Formula, MistakesAreThoseOfTextThatIsReadOnce) {
  for (const char* mistake : {"sqrt(3 - I)", "1/(I - 4)", "pow(I - 4, I - 4)", "ln(4 - I)", "acos(I/3)",
                              "rand(max(0, I - 3))", "sin(W)", "vlength(<W, 1>)", "vlength(vcross(W, x))",
                              "vlength(vnormalize(I - 4))", "vlength(vaxis_rotate(x, (4 - I)*y, 1))", "W"}) {
    for (const bool condition : {false, true}) {
      const std::string text =
          (condition ? "#if (" : "#declare V = 1 + max(0, ") + std::string(mistake) + (condition ? ") #end" : ");");
      const std::string begin =
          "#declare R = seed(1); #declare W = <1, 0, 0, 0, 0>; #declare W = W.x; sphere { 0, 1 } ";
      const std::string end = "#declare W = <1, 2, 3, 4>; ";
      const auto once = load(begin + "#declare I = 4; " + end + text);
      const auto again = load(begin + "#for (I, 1, 4) #if (I = 4) " + end + "#end " + text + " #end");
      EXPECT_NE(errors(once) + warnings(once), "") << text;
      EXPECT_EQ(errors(again), errors(once)) << text;
      EXPECT_EQ(warnings(again), warnings(once)) << text;
    }
  }
}
TEST(Formula, AMistakeIsToldOfAtItsPlace) {
  const auto result =
      load("#declare I = 0;\n#while (I < 9)\n  #declare I = I + 1;\n  #declare V = 1 + sqrt(5 - I);\n#end");
  ASSERT_EQ(errors(result), "'sqrt' needs a number not below 0, found -1\n");
  EXPECT_EQ(result.diagnostics.front().line, 4u);
  EXPECT_EQ(result.diagnostics.front().column, 20u);
}
TEST(Formula, DeprecatedNamesAreToldOfAtEachUse) {
  EXPECT_EQ(
      warnings(load("#for (I, 1, 3) #declare A = I; #end #declare deprecated A = 1; #for (I, 1, 3) #declare B = A + "
                    "1; #end sphere { 0, 1 }")),
      "'A' is deprecated\n'A' is deprecated\n'A' is deprecated\n");
}
TEST(Formula, AMacroBehindAnExpressionMayGoOnWithIt) {
  EXPECT_EQ(debugged("#macro More() + 10 #end #for (I, 1, 4) #debug str(I More(), 0, 0) #end"), "11121314");
  EXPECT_EQ(debugged("#for (I, 1, 4) #debug str(I #if (I > 2) + 10 #end, 0, 0) #end"), "121314");
}

}  // namespace
}  // namespace firstlight::parser
