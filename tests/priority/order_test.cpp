#include "priority/order.h"

#include "priority/schemes.h"
#include "tests/priority/order_support.h"

#include <gtest/gtest.h>

namespace firstlight::priority {
namespace {

using render::RayKind;

TEST(Order, ErrorsPointIntoTheText) {
  EXPECT_EQ(error_of("level, contributon"),
            "column 8: there is no scheme 'contributon' (the nearest is 'contribution'); known are " + scheme_names() +
                "\n  level, contributon\n         ^~~~~~~~~~~");
  EXPECT_EQ(error_of("level,"), "column 7: expected the name of a scheme, found the end\n  level,\n        ^");
  EXPECT_EQ(error_of("(level"), "column 7: expected ')' to close the parenthesis, found the end\n  (level\n        ^");
  EXPECT_EQ(error_of("0.5 level"), "column 5: expected '*' after the weight, found 'level'\n  0.5 level\n      ^~~~~");
  EXPECT_EQ(error_of("level level"),
            "column 7: expected ',', '+', '-' or the end of the scheme, found 'level'\n  level level\n        ^~~~~");
  EXPECT_EQ(error_of("level(3)"), "column 6: 'level' takes no arguments\n  level(3)\n       ^");
  EXPECT_EQ(error_of("level, recursive"),
            "column 1: 'recursive' is no order of waiting rays and cannot be mixed\n  level, recursive\n  ^~~~~");
  EXPECT_EQ(error_of("1e999*level"), "column 1: the number is too large\n  1e999*level\n  ^~~~~");
}

TEST(Order, HostileTextIsRefused) {
  EXPECT_NE(error_of(std::string(100000, '(')), "");
  EXPECT_NE(error_of(std::string(60000, '(')), "");
  EXPECT_NE(error_of("\x01\xff\n"), "");
  EXPECT_NE(error_of(""), "");
  std::string many = "level";
  for (int i = 0; i < 1000; ++i) many += "+level";
  EXPECT_NE(error_of(many), "");
}

TEST(Order, RecursiveHasNoScheme) {
  EXPECT_EQ(scheme_of("recursive"), nullptr);
  EXPECT_EQ(scheme_of(" ( recursive ) "), nullptr);
  std::string error;
  auto order = Order::parse("recursive", scene_input(), error);
  Boost boost;
  boost.kind = Boost::Kind::light;
  EXPECT_NE(order->add(boost), "");
}

TEST(Order, LexicographicMixturesDecideByTheFirstMemberThatDiffers) {
  const auto scheme = scheme_of("region(0,0,9,9), level");
  const Key in_low = key_of(*scheme, task(RayKind::reflection, 0.1f, 4, 5, 5));
  const Key in_high = key_of(*scheme, task(RayKind::reflection, 0.1f, 1, 5, 5));
  const Key out_low = key_of(*scheme, task(RayKind::reflection, 0.1f, 4, 50, 5));
  const Key out_high = key_of(*scheme, task(RayKind::reflection, 0.1f, 0, 50, 5));
  EXPECT_GT(in_high, in_low);
  EXPECT_GT(in_low, out_high);
  EXPECT_GT(out_high, out_low);
}

TEST(Order, ManyMembersStayWithinTheKeysAndTheFirstOnesKeepTheirs) {
  const auto scheme = scheme_of("ray-type, contribution, level, region, distance");
  EXPECT_LE(scheme->key_count(), kBuckets);
  EXPECT_GT(key_of(*scheme, task(RayKind::reflection, 1e-6f)), key_of(*scheme, task(RayKind::shadow, 1.0f)));
  EXPECT_GT(key_of(*scheme, task(RayKind::shadow, 0.5f)), key_of(*scheme, task(RayKind::shadow, 0.25f)));
}

TEST(Order, WeightedMixturesAddWhatIsSpreadOverZeroToOne) {
  const auto mostly_level = scheme_of("0.9*level + 0.1*ray-type");
  const auto mostly_type = scheme_of("0.1*level + 0.9*ray-type");
  const auto early_shadow = task(RayKind::shadow, 0.1f, 1);
  const auto late_reflection = task(RayKind::reflection, 0.1f, 5);
  EXPECT_GT(key_of(*mostly_level, early_shadow), key_of(*mostly_level, late_reflection));
  EXPECT_LT(key_of(*mostly_type, early_shadow), key_of(*mostly_type, late_reflection));
}

TEST(Order, ANegativeWeightTurnsASchemeRound) {
  const auto scheme = scheme_of("-level");
  EXPECT_LT(key_of(*scheme, task(RayKind::reflection, 0.1f, 0)), key_of(*scheme, task(RayKind::reflection, 0.1f, 3)));
  EXPECT_EQ(scheme->key_count(), scheme_of("level")->key_count());
  const auto difference = scheme_of("contribution-level");
  EXPECT_LT(key_of(*difference, task(RayKind::shadow, 0.5f, 0)), key_of(*difference, task(RayKind::shadow, 0.5f, 3)));
}

TEST(Order, WeightsOfZeroAndHugeOnesDoNoHarm) {
  EXPECT_EQ(scheme_of("0*level")->key_count(), 1u);
  const auto huge = scheme_of("1e300*level + 1e300*level - 1e-300*ray-type");
  EXPECT_LT(key_of(*huge, task(RayKind::reflection, 0.1f, 4)), key_of(*huge, task(RayKind::reflection, 0.1f, 0)));
  EXPECT_LE(huge->key_count(), kBuckets);
}

TEST(Order, ParenthesesNestMixtures) {
  const auto scheme = scheme_of("0.5*(ray-type(shadow), level) + 0.5*level, contribution");
  EXPECT_GT(key_of(*scheme, task(RayKind::shadow, 0.1f, 1)), key_of(*scheme, task(RayKind::reflection, 0.9f, 1)));
  EXPECT_GT(key_of(*scheme, task(RayKind::shadow, 0.9f, 1)), key_of(*scheme, task(RayKind::shadow, 0.1f, 1)));
}

TEST(Order, EveryExampleOfTheTableWorks) {
  for (const SchemeRow& row : schemes()) {
    if (row.name == "expr") continue;  // needs the parser's compiler: tests/app
    const auto scheme = scheme_of(row.example);
    EXPECT_EQ(scheme == nullptr, row.make == nullptr) << row.name;
  }
}

}  // namespace
}  // namespace firstlight::priority
