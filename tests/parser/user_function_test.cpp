// Functions that scenes declare. The expected numbers are what POV-Ray 3.7 prints for the same text.
#include "tests/parser/evaluated.h"

namespace firstlight::parser {
namespace {

std::string of(const std::string& declared, const std::string& expression) {
  return debugged("#declare F = " + declared + "; #debug str(" + expression + ", 0, 6)");
}

TEST(UserFunction, IsCalledInExpressions) {
  EXPECT_EQ(of("function { x + 10*y + 100*z }", "F(1, 2, 3) + 1"), "322.000000");
  EXPECT_EQ(of("function(a, b) { a*b }", "-F(2, 3) * F(1, 4)"), "-24.000000");
  EXPECT_EQ(of("function(x) { x*x }", "F(F(3))"), "81.000000");
  EXPECT_EQ(of("function(x, y) { x/y }", "F(1 4)"), "0.250000") << "commas are optional";
}

TEST(UserFunction, CoordinatesThatAreNoParametersAreZeroOrTheirLike) {
  EXPECT_EQ(of("function(a, b) { a + b + x }", "F(5, 6)"), "11.000000");
  EXPECT_EQ(of("function { u + v }", "F(5, 6, 7)"), "11.000000");
  EXPECT_EQ(of("function(u, v) { x*10 + y }", "F(5, 6)"), "56.000000");
}

TEST(UserFunction, CallsOthersAndKnowsWhatIsDeclared) {
  EXPECT_EQ(debugged("#declare K = 3; #declare V = <1, 2, 3>; #declare A = array[2] {5, 7}"
                     "#declare G = function(x) { x + K*V.y + A[1] }"
                     "#declare F = function(x) { G(x)*G(2*x) + pi - pi }"
                     "#macro Twice(E) 2*(E) #end #local H = function(q) { Twice(2)*q + clock }"
                     "#debug str(F(1) + H(1.5), 0, 3)"),
            "216.000");
}

TEST(UserFunction, SumsAndProducts) {
  EXPECT_EQ(of("function(x) { sum(i, 1, x, i*i) }", "F(5)"), "55.000000");
  EXPECT_EQ(of("function(x) { prod(i, 1, x, i) + sum(j, 1, 3, sum(k, 1, j, k)) }", "F(5)"), "130.000000");
  EXPECT_EQ(of("function(x) { 1 + 2*sum(i, 5, x, i) + prod(i, 5, x, i) }", "F(4)"), "2.000000");
}

TEST(UserFunction, ConstantsAreJoinedAsPovRayJoinsThem) {
  EXPECT_EQ(of("function(x) { x - 2*3 - 1 }", "F(0)"), "-5.000000");
  EXPECT_EQ(of("function(x) { x - 1 - 2*3 }", "F(0)"), "-7.000000");
  EXPECT_EQ(of("function(x) { x < 1 < 2 }", "F(5)"), "0.000000");
  EXPECT_EQ(debugged("#declare F = function(x) { pow(x, 3) } #debug str(F(0.7), 0, 17)"), "0.34299999999999992");
}

TEST(UserFunction, HasVectorsByTheirComponents) {
  EXPECT_EQ(of("function { transform { translate <1, 2, 3> rotate 90*z } }",
               "F(1, 0, 0).y + vlength(F(0, 0, 0) - F(0, 0, 0))"),
            "2.000000");
  EXPECT_EQ(debugged("#declare T = function { transform { scale <1, 2, 3> } }"
                     "#declare F = function(x) { T(x, x, x).x + T(x, x, x).z*10 } #debug str(F(1), 0, 1)"),
            "31.0");
}

TEST(UserFunction, BuiltInFunctionsHaveNumbers) {
  EXPECT_EQ(of("function { internal(61) }", "F(3, 4, 0, 1)"), "4.000000");
  EXPECT_EQ(of("function { internal(78) }", "F(0.3, 0.4, 0.5, 3)"), "0.678075");
  EXPECT_EQ(of("function { internal(77) }", "1"), "error: there is no internal function of this number");
}

TEST(UserFunction, TheNoiseGeneratorIsTheScenes) {
  const std::string text = "#declare F = function { internal(76) } #debug str(F(0.3, 0.4, 0.5), 0, 6)";
  EXPECT_EQ(debugged(text), "0.475871");
  EXPECT_EQ(debugged("global_settings { noise_generator 3 } " + text), "0.678075");
  EXPECT_EQ(debugged("#version 3.1; " + text), "0.419032");
}

TEST(UserFunction, MistakesAreToldAtTheirPlace) {
  EXPECT_EQ(of("function { x + nope }", "1"),
            "error: expected a number, found the unknown name 'nope'; there are x, y, z");
  EXPECT_EQ(of("function(a) { a }", "F()"), "error: expected 1 arguments for 'F', found 0");
  EXPECT_EQ(of("function { x/0 }", "1"), "error: division by zero");
  EXPECT_EQ(of("function { transform { scale 2 } }", "vlength(F(1, 0, 0)) + G"),
            "error: expected a numeric expression, found undeclared identifier 'G'");
}

TEST(UserFunction, EndlessWorkIsRefused) {
  EXPECT_EQ(of("function(x) { sum(i, 0, x, sum(j, 0, x, j)) }", "F(1e9)"),
            "error: the loops in the function 'F' take too long");
  const std::string message = "error: functions call each other too often or too deep here";
  const auto begins = [&](const std::string& text) { return debugged(text).substr(0, message.size()); };
  EXPECT_EQ(begins("#declare A = array[2000]; #declare A[0] = function(x) { x }"
                   "#for (I, 1, 1999) #declare A[I] = function(x) { A[I - 1](x) + 1 } #end"),
            message);
  EXPECT_EQ(begins("#declare A = array[64]; #declare A[0] = function(x) { x }"
                   "#for (I, 1, 63) #declare A[I] = function(x) { A[I - 1](x) + A[I - 1](x) } #end"),
            message);
}

TEST(UserFunction, IsHandedOnByName) {
  EXPECT_EQ(debugged("#macro Apply(F, X) F(X) #end #declare Square = function(x) { x*x }"
                     "#declare Other = Square; #debug str(Apply(Square, 5) + Other(2), 0, 0)"
                     "#debug str(Apply(function(x) { x + 1 }, 5), 0, 0)"),
            "296");
}

TEST(Spline, GoesThroughItsPoints) {
  const auto at = [](const std::string& kind, const std::string& t) {
    return debugged("#declare S = spline { " + kind +
                    " 0, <0, 0, 0> 1, <1, 2, 0> 2, <2, 0, 1> 4, <3, 1, 0> }"
                    "#debug vstr(3, S(" +
                    t + "), \" \", 0, 6)");
  };
  EXPECT_EQ(at("linear_spline", "0.5"), "0.500000 1.000000 0.000000");
  EXPECT_EQ(at("quadratic_spline", "1.5"), "1.500000 1.500000 0.375000");
  EXPECT_EQ(at("cubic_spline", "1.5"), "1.531250 1.093750 0.531250");
  EXPECT_EQ(at("natural_spline", "1.5"), "1.524457 1.203804 0.491848");
  EXPECT_EQ(at("natural_spline", "-3"), "0.000000 0.000000 0.000000");
  EXPECT_EQ(at("linear_spline", "1.5, cubic_spline"), "1.531250 1.093750 0.531250");
}

TEST(Spline, CanBeAFunctionAndAnotherSplinesBeginning) {
  EXPECT_EQ(debugged("#declare S = spline { linear_spline 0, <0, 1> 1, <1, 5> }"
                     "#declare T = spline { S 2, <2, 0> } #declare F = function { spline { T } }"
                     "#declare G = function(x) { F(x).u + F(x).v } #debug str(G(1.5), 0, 3)"),
            "4.000");
}

}  // namespace
}  // namespace firstlight::parser
