#include "app/study/curve.h"
#include "tests/app/study_example.h"

#include <gtest/gtest.h>

#include <vector>

namespace firstlight::app {
namespace {

using Curve = std::vector<CurvePoint>;

TEST(StudyCurve, AreaIsOfTrapezoids) {
  EXPECT_DOUBLE_EQ(area_under(Curve{{0.0, 1.0}, {1.0, 0.0}}), 0.5);
  EXPECT_DOUBLE_EQ(area_under(Curve{{0.0, 1.0}, {0.25, 1.0}, {0.75, 0.2}, {1.0, 0.0}}), 0.25 + 0.3 + 0.025);
  EXPECT_DOUBLE_EQ(area_under(Curve{{2.0, 3.0}}), 0.0);
  EXPECT_DOUBLE_EQ(area_under({}), 0.0);
}

TEST(StudyCurve, SettlesWhereItCrossesForTheLastTime) {
  const Curve curve{{0.0, 1.0}, {0.2, 0.02}, {0.4, 0.25}, {0.6, 0.05}, {1.0, 0.0}};
  EXPECT_DOUBLE_EQ(settles_below(curve, 0.05).value(), 0.6);
  EXPECT_DOUBLE_EQ(settles_below(curve, 0.15).value(), 0.5);
  EXPECT_DOUBLE_EQ(settles_below(curve, 0.025).value(), 0.8);
}

TEST(StudyCurve, SettlesAtOnceOrNever) {
  EXPECT_DOUBLE_EQ(settles_below(Curve{{0.1, 0.01}, {1.0, 0.0}}, 0.05).value(), 0.1);
  EXPECT_FALSE(settles_below(Curve{{0.0, 1.0}, {1.0, 0.1}}, 0.05).has_value());
  EXPECT_FALSE(settles_below({}, 0.05).has_value());
}

TEST(StudyCurve, ValuesLieOnStraightLines) {
  const Curve curve{{1.0, 4.0}, {2.0, 6.0}, {2.0, 7.0}, {4.0, 5.0}};
  EXPECT_DOUBLE_EQ(value_at(curve, 1.5), 5.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 3.0), 6.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 2.0), 7.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 0.0), 4.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 9.0), 5.0);
}

TEST(StudyCurve, MedianOfOddAndEvenNumbers) {
  EXPECT_DOUBLE_EQ(median(std::vector{5.0, 1.0, 3.0}), 3.0);
  EXPECT_DOUBLE_EQ(median(std::vector{4.0, 1.0, 3.0, 2.0}), 2.5);
}

TEST(Study, CurvesBeginWithTheBlackPicture) {
  const Study study = made_up_study();
  const SchemeStudy& scheme = study.schemes[1];
  for (const Over over : {Over::seconds, Over::share}) {
    const auto difference = difference_curve(scheme, over);
    ASSERT_EQ(difference.size(), scheme.moments.size() + 1);
    EXPECT_EQ(difference.front().x, 0.0);
    EXPECT_EQ(difference.front().y, 1.0);
    EXPECT_DOUBLE_EQ(difference.back().x, over == Over::share ? 1.0 : 1.5);
    EXPECT_EQ(difference.back().y, 0.0);
    EXPECT_EQ(flip_curve(study, scheme, over).front().y, 0.8);
  }
  EXPECT_EQ(queue_curve(scheme)[50].y, 250.0);
  EXPECT_EQ(rays_curve(scheme, render::RayKind::shadow)[50].y, 1500.0);
}

// The area under (1 - s)^n is 1 / (n + 1), and it is below 5 % from 1 - 0.05^(1/n) on.
TEST(Study, SummaryHoldsWhatTheCurvesSay) {
  const Study study = made_up_study();
  const SchemeSummary summary = summarize(study, study.schemes[1]);
  EXPECT_NEAR(summary.area_by_share, 0.1, 1e-3);
  EXPECT_NEAR(summary.area_by_seconds, 0.15, 1.5e-3);
  EXPECT_NEAR(summary.flip_area_by_share, 0.8 / 5.5, 1e-3);
  EXPECT_NEAR(summary.five_percent.value(), 1.0 - 0.7169, 1e-3);
  EXPECT_NEAR(summary.one_percent.value(), 1.0 - 0.5995, 1e-3);
  EXPECT_DOUBLE_EQ(summary.peak_of_worst_case, 0.25);
}

// A run that is looked at may be slower; its rays come in the same order all the same.
TEST(Study, ClockEndsAtTheMedianOfTheUndisturbedRounds) {
  SchemeStudy scheme = made_up_scheme("level", 6.0, 1.0);
  scheme.seconds = {4.0, 1.0, 3.0};
  scheme.preview = Reached{0.06, 0.0};
  scheme.first_image = Reached{2.0, 0.0};
  scheme.pictures.push_back({0.5, 3.0, 0.5, ""});
  set_clock(scheme);
  EXPECT_DOUBLE_EQ(scheme.moments.back().seconds, 3.0);
  EXPECT_DOUBLE_EQ(scheme.moments[49].seconds, 1.5);
  EXPECT_DOUBLE_EQ(scheme.pictures[0].seconds, 1.5);
  EXPECT_NEAR(scheme.preview->share, 0.02, 1e-12);
  EXPECT_NEAR(scheme.first_image->share, 2.0 / 3.0, 1e-12);
}

// Rounds in which the machine is slow are slow for both.
TEST(Study, RatiosArePaired) {
  Study study = made_up_study();
  study.schemes[0].seconds = {1.0, 10.0, 2.0};
  study.schemes[1].seconds = {0.8, 9.0, 1.4};
  const SchemeSummary summary = summarize(study, study.schemes[1]);
  EXPECT_DOUBLE_EQ(summary.seconds, 1.4);
  EXPECT_DOUBLE_EQ(summary.ratio, 0.8);
  EXPECT_DOUBLE_EQ(summary.least_ratio, 0.7);
  EXPECT_DOUBLE_EQ(summary.most_ratio, 0.9);
}

}  // namespace
}  // namespace firstlight::app
