// The expected numbers are what POV-Ray 3.7 prints for the same expressions.
#include "tests/parser/evaluated.h"

namespace firstlight::parser {
namespace {

TEST(Expression, ProductsBindMoreThanSums) { EXPECT_EQ(number("1 + 2*3 - 4/2", 0), "5"); }
TEST(Expression, SignsBindMost) { EXPECT_EQ(number("-2*-3 + +1", 0), "7"); }
TEST(Expression, NotIsOneOrZero) { EXPECT_EQ(number("!0 + !5*10", 0), "1"); }
TEST(Expression, ComparesInParentheses) {
  EXPECT_EQ(number("(1<2) + (2<=2)*10 + (3>4)*100 + (3>=3)*1000 + (1!=2)*10000 + (1=1)*100000", 0), "111011");
}
TEST(Expression, NearlyEqualIsEqual) { EXPECT_EQ(number("(1 = 1 + 1e-11)", 0), "1"); }
TEST(Expression, AndAndOrGoFromLeftToRight) { EXPECT_EQ(number("(1 & 0 | 1) + (1 | 1 & 0)*10", 0), "1"); }
TEST(Expression, ChoosesByCondition) { EXPECT_EQ(number("(0 ? 2 : 1 ? 5 : 6)", 0), "5"); }
TEST(Expression, ComparesStrings) {
  EXPECT_EQ(number("(\"a\" = \"a\") + (\"a\" < \"b\")*2 + (\"b\" <= \"a\")*4", 0), "3");
}
TEST(Expression, DivisionByZeroIsInfiniteWithAWarning) {
  const auto result = load("#declare A = 1/0; #debug str(A, 0, 0) sphere { 0, 1 }");
  EXPECT_EQ(messages(result, render::Diagnostic::Severity::debug), "inf\n");
  EXPECT_EQ(messages(result, render::Diagnostic::Severity::warning), "division by zero\n");
}

TEST(Expression, ANumberMeetsAVectorInEachComponent) { EXPECT_EQ(vector("<1, 2, 3>*2 + 1"), "3.0000 5.0000 7.0000"); }
TEST(Expression, AShortVectorIsFilledWithZeros) { EXPECT_EQ(vector("<1, 2>*x + z"), "1.0000 0.0000 1.0000"); }
TEST(Expression, VectorsAreDividedByComponent) { EXPECT_EQ(vector("<1, 2, 3>/<2, 4, 8>"), "0.5000 0.5000 0.3750"); }
TEST(Expression, CommasInVectorsAreOptional) { EXPECT_EQ(vector("<1 2 3>"), "1.0000 2.0000 3.0000"); }
TEST(Expression, PicksComponents) {
  EXPECT_EQ(number("(<1, 2, 3>*3).y + <4, 5, 6>.z*10 + <1, 2, 3, 4>.t*100 + <7, 8>.v*1000", 0), "8466");
}
TEST(Expression, AMissingComponentIsAnError) {
  EXPECT_EQ(number("<1, 2>.z"), "error: a value of 2 components has no '.z'");
}
TEST(Expression, GreyIsWeighted) { EXPECT_EQ(number("<1, 0.5, 0.25>.gray"), "0.620000"); }
TEST(Expression, AVectorIsNoNumber) {
  EXPECT_EQ(debugged("sphere { 0, <1, 2, 3> }"), "error: expected a float, found a vector expression");
}
TEST(Expression, AnUndeclaredNameIsNamed) {
  EXPECT_EQ(number("2*Nope"), "error: expected a numeric expression, found undeclared identifier 'Nope'");
}

TEST(Color, EveryWordSetsItsComponents) {
  EXPECT_EQ(vector("rgb <1, 0.5, 0.25>", 5), "1.0000 0.5000 0.2500 0.0000 0.0000");
  EXPECT_EQ(vector("rgbf <1, 0.5, 0.25, 0.1>", 5), "1.0000 0.5000 0.2500 0.1000 0.0000");
  EXPECT_EQ(vector("rgbt <1, 0.5, 0.25, 0.1>", 5), "1.0000 0.5000 0.2500 0.0000 0.1000");
  EXPECT_EQ(vector("rgbft <1, 0.5, 0.25, 0.1, 0.7>", 5), "1.0000 0.5000 0.2500 0.1000 0.7000");
}
TEST(Color, ANumberIsGrey) { EXPECT_EQ(vector("color rgb 0.3", 5), "0.3000 0.3000 0.3000 0.0000 0.0000"); }
TEST(Color, SingleComponentsComeInAnyOrder) {
  EXPECT_EQ(vector("blue 0.2 red 0.3 transmit 0.9", 5), "0.3000 0.0000 0.2000 0.0000 0.9000");
}
TEST(Color, ADeclaredColorCanBeChanged) {
  EXPECT_EQ(debugged("#declare C = rgb <1, 2, 3>; #declare D = color C*2 filter 0.5; #debug vstr(5, D, \" \", 0, 1)"),
            "2.0 4.0 6.0 0.5 0.0");
}
TEST(Color, IsKeptInSinglePrecision) {
  EXPECT_EQ(debugged("#declare C = rgb 0.1; #debug str(C.red, 0, 12)"), "0.100000001490");
}
TEST(Color, SrgbIsDecoded) { EXPECT_EQ(vector("srgb <0.5, 0.2, 0.03>"), "0.2140 0.0331 0.0023"); }
TEST(Color, SrgbNeedsAssumedGamma) {
  const auto result = load_bare("#version 3.7;\n#declare C = srgb 1;");
  EXPECT_EQ(errors(result), "'srgb' needs an 'assumed_gamma' in 'global_settings' before it\n");
}

TEST(Function, OfOneNumber) {
  EXPECT_EQ(number("abs(-3.5)", 1), "3.5");
  EXPECT_EQ(number("acos(0.3)"), "1.266104");
  EXPECT_EQ(number("ceil(-1.5)*100 + floor(-1.5)*10 + int(-1.7)", 0), "-121");
  EXPECT_EQ(number("ln(3)"), "1.098612");
  EXPECT_EQ(number("log(3)"), "0.477121");
  EXPECT_EQ(number("degrees(1)"), "57.295780");
  EXPECT_EQ(number("asinh(1)"), "0.881374");
  EXPECT_EQ(number("sqr(3)", 0), "9");
}
TEST(Function, OfSeveralNumbers) {
  EXPECT_EQ(number("atan2(1, -2)"), "2.677945");
  EXPECT_EQ(number("div(-7, 2)", 0), "-3");
  EXPECT_EQ(number("mod(7.5, 2)", 1), "1.5");
  EXPECT_EQ(number("max(1, 5, 3) + min(4, 2, 3)*10", 0), "25");
  EXPECT_EQ(number("select(-1, 2, 3) + select(0, 2, 3, 4)*10 + select(1, 2, 3, 4)*100", 0), "432");
  EXPECT_EQ(number("bitwise_and(12, 10) + bitwise_or(12, 10)*100 + bitwise_xor(12, 10)*10000", 0), "61408");
}
TEST(Function, OfVectors) {
  EXPECT_EQ(vector("vrotate(x, <10, 20, 30>)"), "0.8138 0.4698 -0.3420");
  EXPECT_EQ(vector("vaxis_rotate(<1, 2, 3>, <1, 1, 0>, 33)"), "2.2360 0.7640 2.9011");
  EXPECT_EQ(vector("vcross(<1, 2, 3>, <4, 5, 6>)"), "-3.0000 6.0000 -3.0000");
  EXPECT_EQ(vector("vnormalize(<0, 3, 4>)"), "0.0000 0.6000 0.8000");
  EXPECT_EQ(number("vdot(<1, 2, 3>, <4, 5, 6>) + vlength(<0, 3, 4>)*100", 0), "532");
}
TEST(Function, OutsideItsDomainIsAnError) {
  EXPECT_EQ(number("sqrt(-1)"), "error: 'sqrt' needs a number not below 0, found -1");
  EXPECT_EQ(number("ln(0)"), "error: 'ln' needs a number above 0, found 0");
  EXPECT_EQ(number("pow(0, 0)"), "error: 'pow' of two zeros has no value");
}
TEST(Function, RandFollowsPovRaysSequence) {
  EXPECT_EQ(debugged("#declare S = seed(123); #debug str(rand(S), 0, 12) #debug \" \" #debug str(rand(S), 0, 12)"),
            "0.904772982212 0.995137868914");
}
TEST(Function, StreamsOfRandAreIndependent) {
  EXPECT_EQ(debugged("#declare A = seed(123); #declare B = seed(7); #declare X = rand(B); #debug str(rand(A), 0, 12)"),
            "0.904772982212");
}
TEST(Function, RandWithoutSeedIsAnError) {
  EXPECT_EQ(number("rand(0)"), "error: 'rand' needs a stream that 'seed' has made, found 0");
}
TEST(Function, VturbulenceIsASumOfNoise) {
  EXPECT_EQ(vector("vturbulence(2.1, 0.6, 4, <0.3, -0.4, 12.5>)"), "-0.2062 -0.3291 0.1052");
}
TEST(Function, ImageSizeIsDeclared) { EXPECT_EQ(number("image_width/image_height"), "1.333333"); }

TEST(String, FunctionsOfStrings) {
  EXPECT_EQ(debugged("#debug concat(str(3.14159, 8, 2), \"|\", str(3.14159, -8, 2), \"|\", str(-3.5, 0, -1))"),
            "    3.14|00003.14|-3.500000");
  EXPECT_EQ(debugged("#debug concat(chr(65), strupr(\"abc\"), strlwr(\"ABC\"), substr(\"hello\", 2, 3))"),
            "AABCabcell");
  EXPECT_EQ(number("asc(\"A\") + strlen(\"hello\")*100 + val(\"12.5abc\")*1000", 0), "13065");
}
TEST(String, EscapesAreReplaced) { EXPECT_EQ(debugged(R"(#debug "a\tb\\ \"q\" \u0041")"), "a\tb\\ \"q\" A"); }
TEST(String, AnUnknownEscapeIsAnError) {
  EXPECT_EQ(debugged(R"(#debug "a\qb")"), "error: '\\q' is no escape sequence of strings");
}
TEST(String, SubstrMustFit) {
  EXPECT_EQ(debugged("#debug substr(\"abc\", 2, 5)"),
            "error: 'substr' of 5 characters from character 2 on does not fit a string of 3");
}

}  // namespace
}  // namespace firstlight::parser
