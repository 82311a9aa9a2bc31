// Expressions as schemes: the priority engine with the parser's compiler.
#include "parser/function_text.h"
#include "priority/order.h"
#include "priority/schemes.h"
#include "tests/priority/order_support.h"

#include <gtest/gtest.h>

namespace firstlight::priority {
namespace {

using render::RayKind;

SchemeInput with_compiler() {
  SchemeInput input = scene_input();
  input.compile = parser::compile_text;
  return input;
}

std::shared_ptr<const Scheme> compiled(std::string_view text) {
  std::string error;
  const auto order = Order::parse(text, with_compiler(), error);
  EXPECT_TRUE(order.has_value()) << text << ": " << error;
  return order ? order->scheme() : nullptr;
}

std::string problem(std::string_view text) {
  std::string error;
  EXPECT_FALSE(Order::parse(text, with_compiler(), error).has_value()) << text;
  return error;
}

TEST(ExpressionScheme, LargerValuesLeaveFirst) {
  const auto scheme = compiled("expr(weight*(level < 3) + (x > 50))");
  const Key right = key_of(*scheme, task(RayKind::reflection, 0.1f, 5, 51));
  const Key left = key_of(*scheme, task(RayKind::reflection, 0.9f, 1, 50));
  const Key deep = key_of(*scheme, task(RayKind::reflection, 0.9f, 3, 50));
  EXPECT_GT(right, left);
  EXPECT_GT(left, deep);
}

TEST(ExpressionScheme, NegativeNumbersZeroAndWhatIsNoNumberHaveTheirPlaces) {
  const auto key = [](const char* text) { return key_of(*compiled(text), task(RayKind::reflection, 0.5f, 2)); };
  EXPECT_EQ(key("expr(sqrt(-1))"), 0u);
  EXPECT_LT(key("expr(-1/0)"), key("expr(-1000)"));
  EXPECT_LT(key("expr(-2)"), key("expr(-1)"));
  EXPECT_LT(key("expr(-1)"), key("expr(0)"));
  EXPECT_LT(key("expr(0)"), key("expr(0.001)"));
  EXPECT_LT(key("expr(level)"), key("expr(level + 1)"));
  EXPECT_LT(key("expr(1e6)"), key("expr(1/0)"));
  EXPECT_EQ(key("expr(1e99)"), key("expr(1/0)"));
}

TEST(ExpressionScheme, KnowsTheAttributesOfARay) {
  render::RayTask feelers = task(RayKind::shadow, 0.5f, 2, 30, 40);
  feelers.origin = render::Vec3(0.0, 4.0, 0.0);
  ASSERT_TRUE(feelers.add_feeler(1, render::PackedRgb(render::Rgb(0.25f, 0.0f, 0.5f))));
  feelers.object = 3;
  const auto holds = [&](const std::string& condition) {
    const auto scheme = compiled("expr(" + condition + ")");
    return key_of(*scheme, feelers) > key_of(*compiled("expr(0)"), feelers);
  };
  for (const char* condition : {"x = 30",
                                "y = 40",
                                "level = 2",
                                "type = shadow",
                                "type != reflection",
                                "cost = 2",
                                "red = 0.5",
                                "green = 0.5",
                                "blue = 0.625",
                                "weight = 0.625",
                                "object = 3",
                                "light = 0",
                                "light_distance = 6",
                                "abs(light_intensity - 0.5) < 1e-6",
                                "distance = 4",
                                "width = 100",
                                "height = 80",
                                "sample = 4030",
                                "Leg",
                                "Table",
                                "cylinder",
                                "!Chair",
                                "!sphere"}) {
    EXPECT_TRUE(holds(condition)) << condition;
  }
  EXPECT_FALSE(holds("Chair"));
  EXPECT_FALSE(holds("type = primary"));
}

TEST(ExpressionScheme, MixesWithOthers) {
  const auto scheme = compiled("region(0,0,9,9), expr(max(red, blue))");
  EXPECT_GT(key_of(*scheme, task(RayKind::reflection, 0.1f, 0, 5, 5)),
            key_of(*scheme, task(RayKind::reflection, 0.9f, 0, 50, 5)));
  EXPECT_GT(key_of(*scheme, task(RayKind::reflection, 0.9f, 0, 5, 5)),
            key_of(*scheme, task(RayKind::reflection, 0.1f, 0, 5, 5)));
}

TEST(ExpressionScheme, TellsPixelsApartOnlyWhenItLooksAtThem) {
  EXPECT_TRUE(compiled("expr(x)")->tells_pixels_apart());
  EXPECT_TRUE(compiled("level, expr(1 - y)")->tells_pixels_apart());
  EXPECT_FALSE(compiled("expr(weight*level)")->tells_pixels_apart());
}

TEST(ExpressionScheme, ErrorsPointIntoTheExpression) {
  EXPECT_EQ(problem("level, expr(weight + )"),
            "column 22: expected a number, found the end\n  level, expr(weight + )\n                       ^");
  EXPECT_NE(
      problem("expr(weigth)").find("column 6: expected a number, found the unknown name 'weigth'; there are weight"),
      std::string::npos);
  EXPECT_NE(problem("expr(2*(x + 1)").find("column 15: expected ')' to close 'expr', found the end"),
            std::string::npos);
  EXPECT_NE(problem("expr(x > #)").find("column 10: "), std::string::npos);
  EXPECT_EQ(problem("level + expr"),
            "column 9: 'expr' needs an expression: expr(weight*(level < 3))\n  level + expr\n          ^~~~");
  EXPECT_NE(error_of("expr(x)").find("column 6: "), std::string::npos) << "without a compiler";
}

}  // namespace
}  // namespace firstlight::priority
