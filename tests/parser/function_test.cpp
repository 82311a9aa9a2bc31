#include "parser/function_text.h"

#include "parser/expression/function_compiler.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace firstlight::parser {
namespace {

constexpr std::array<std::string_view, 3> kParameters{"x", "y", "sphere"};

double value_of(std::string_view text, double x = 0.0, double y = 0.0, double sphere = 0.0) {
  const render::CompileResult compiled = compile_text(text, kParameters);
  EXPECT_NE(compiled.program, nullptr) << text << ": " << compiled.error;
  if (compiled.program == nullptr) return NAN;
  return compiled.program->evaluate(std::array{x, y, sphere});
}

struct Expected {
  std::string_view text;
  double value;
};

TEST(Function, OperatorsHaveTheRanksOfTheLanguage) {
  for (const Expected& e : std::vector<Expected>{{"2+3*4", 14},
                                                 {"(2+3)*4", 20},
                                                 {"2-3-4", -5},
                                                 {"24/4/2", 3},
                                                 {"-2*-3", 6},
                                                 {"--2", 2},
                                                 {"+-+2", -2},
                                                 {"2 - -3", 5},
                                                 {"1+1 = 2", 1},
                                                 {"1 < 2 < 1", 0},
                                                 {"3 >= 3 & 2 <= 1 | 1 != 2", 1},
                                                 {"1 | 0 & 0", 1},
                                                 {"!0 + !5", 1},
                                                 {"1e-11 = 0", 0},
                                                 {"!1e-11", 0},
                                                 {".5e1*2.", 10}}) {
    EXPECT_DOUBLE_EQ(value_of(e.text), e.value) << e.text;
  }
}

TEST(Function, KnowsTheFunctionsOfNumbers) {
  for (const Expected& e : std::vector<Expected>{{"abs(-3)", 3},
                                                 {"acos(0.5)", std::acos(0.5)},
                                                 {"acosh(2)", std::acosh(2.0)},
                                                 {"asin(0.5)", std::asin(0.5)},
                                                 {"asinh(2)", std::asinh(2.0)},
                                                 {"atan(2)", std::atan(2.0)},
                                                 {"atan2(1, -2)", std::atan2(1.0, -2.0)},
                                                 {"atanh(0.5)", std::atanh(0.5)},
                                                 {"ceil(-1.5)", -1},
                                                 {"cos(1)", std::cos(1.0)},
                                                 {"cosh(1)", std::cosh(1.0)},
                                                 {"degrees(pi)", 180},
                                                 {"div(-7, 2)", -3},
                                                 {"exp(1)", std::numbers::e},
                                                 {"floor(-1.5)", -2},
                                                 {"int(-1.5)", -1},
                                                 {"ln(10)", std::numbers::ln10},
                                                 {"log(1000)", 3},
                                                 {"max(1, 5, 3)", 5},
                                                 {"min(4, 2, 3)", 2},
                                                 {"mod(-7, 4)", -3},
                                                 {"pow(2, 10)", 1024},
                                                 {"radians(180)", std::numbers::pi},
                                                 {"select(-1, 10, 20)", 10},
                                                 {"select(0, 10, 20)", 20},
                                                 {"select(1, 10, 20)", 20},
                                                 {"select(-1, 10, 20, 30)", 10},
                                                 {"select(0, 10, 20, 30)", 20},
                                                 {"select(2, 10, 20, 30)", 30},
                                                 {"sin(1)", std::sin(1.0)},
                                                 {"sinh(1)", std::sinh(1.0)},
                                                 {"sqr(-3)", 9},
                                                 {"sqrt(2)", std::numbers::sqrt2},
                                                 {"tan(1)", std::tan(1.0)},
                                                 {"tanh(1)", std::tanh(1.0)},
                                                 {"true + no", 1}}) {
    EXPECT_DOUBLE_EQ(value_of(e.text), e.value) << e.text;
  }
}

TEST(Function, ParametersHideTheWordsOfTheLanguage) {
  EXPECT_DOUBLE_EQ(value_of("x*10 + y", 3, 4), 34);
  EXPECT_DOUBLE_EQ(value_of("2*sphere", 0, 0, 7), 14);
  EXPECT_DOUBLE_EQ(value_of("select(x, y, sphere)", -1, 5, 6), 5);
  EXPECT_DOUBLE_EQ(value_of("max(x, y) - min(x, y, sphere)", 3, 4, -2), 6);
}

TEST(Function, WhatHasNoValueIsNoError) {
  EXPECT_TRUE(std::isinf(value_of("1/x")));
  EXPECT_TRUE(std::isnan(value_of("sqrt(-1)")));
  EXPECT_TRUE(std::isnan(value_of("mod(x, y)")));
  EXPECT_DOUBLE_EQ(value_of("int(1e99)"), -2147483648.0);
  EXPECT_TRUE(std::isinf(value_of("ln(x)")));
}

TEST(Function, ConstantsAreComputedOnce) {
  EXPECT_EQ(compile_text("2*pi + max(1, 2, 3) - select(1, 2, 3)", kParameters).program->instructions().size(), 1u);
  EXPECT_EQ(compile_text("x*(2 + 3)", kParameters).program->instructions().size(), 2u);
}

TEST(Function, ManyPointsGiveWhatEachGivesAlone) {
  const auto program = compile_text("select(x - y, sin(x*sphere), y/x, pow(x, 2) & y)", kParameters).program;
  std::vector<double> x, y, s;
  for (int i = 0; i < 1000; ++i) {
    x.push_back(i % 7 - 3.0);
    y.push_back(i % 5 - 2.0);
    s.push_back(0.1 * i);
  }
  std::vector<double> results(x.size());
  const std::array<std::span<const double>, 3> columns{x, y, s};
  program->evaluate(columns, results);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double alone = program->evaluate(std::array{x[i], y[i], s[i]});
    EXPECT_TRUE(alone == results[i] || (std::isnan(alone) && std::isnan(results[i]))) << i;
  }
}

struct Wrong {
  std::string_view text;
  std::size_t at;
  std::size_t length;
  std::string_view message;
};

TEST(Function, ErrorsPointIntoTheText) {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"x + ", 4, 1, "expected a number, found the end"},
           {"", 0, 1, "expected a number, found the end"},
           {"x + weigth", 4, 6, "expected a number, found the unknown name 'weigth'; there are x, y, sphere"},
           {"x y", 2, 1, "expected an operator or the end of the expression, found 'y'"},
           {"(x", 2, 1, "expected ')' to close the parenthesis, found the end"},
           {"x\n+ )", 4, 1, "expected a number, found ')'"},
           {"sin x", 4, 1, "expected '(' before the arguments of 'sin', found 'x'"},
           {"sin(x, y)", 0, 3, "too many arguments of 'sin'"},
           {"pow(x)", 5, 1, "expected ',' and a further argument of 'pow', found ')'"},
           {"x + box", 4, 3, "expected a number, found 'box', which is no function of numbers"},
           {"x + 1..2", 4, 3, "expected a number, found one with a second '.'"},
           {"x \"a\"", 2, 3, "expected an operator or the end of the expression, found string \"a\""}}) {
    const render::CompileResult compiled = compile_text(wrong.text, kParameters);
    EXPECT_EQ(compiled.program, nullptr) << wrong.text;
    EXPECT_EQ(compiled.error, wrong.message) << wrong.text;
    EXPECT_EQ(compiled.at, wrong.at) << wrong.text;
    EXPECT_EQ(compiled.length, wrong.length) << wrong.text;
  }
}

TEST(Function, HostileTextIsRefusedWithoutACrash) {
  std::string chain = "x";
  for (int i = 0; i < 70000; ++i) chain += "+x";
  for (const std::string& text : {std::string(100000, '('), std::string(100000, '-'), chain,
                                  "#if (1)" + std::string(50, ' '), std::string("x\0y", 3), std::string("/* x"),
                                  std::string("\"x"), std::string("\xff\xfe"), std::string("x \x80")}) {
    EXPECT_EQ(compile_text(text, kParameters).program, nullptr);
    EXPECT_NE(compile_text(text, kParameters).error, "");
  }
  std::string right = "x";
  for (int i = 0; i < 150; ++i) right = "x + (" + right + ")";
  EXPECT_EQ(compile_text(right, kParameters).error, "the expression is too large");
  std::string negated = std::string(1000, '-') + "x";
  EXPECT_DOUBLE_EQ(value_of(negated, 3), 3);
}

}  // namespace
}  // namespace firstlight::parser
