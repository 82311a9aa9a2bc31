#include "app/compare/agreement.h"
#include "app/compare/kept_json.h"
#include "app/compare/record_json.h"
#include "app/compare/sweep_json.h"
#include "app/compare/totals.h"
#include "tests/app/compare_example.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace firstlight::app::compare {
namespace {

/// Two rendered, 4 and 0.25 times as fast in tracing; three that lack features.
std::vector<SceneRecord> some_records() {
  return {rendered_record("shapes/fast", 1.0, 0.25), rendered_record("shapes/slow_one", 0.5, 4.0, 4.0),
          lacking_record("shapes/foggy", {"fog"}), lacking_record("lights/both", {"fog", "area lights", "fog"}),
          lacking_record("top", {"area lights"})};
}

TEST(CompareTotals, RatiosAreGeometricMeans) {
  const Totals sum = totals(some_records());
  EXPECT_EQ(sum.scenes, 5u);
  EXPECT_EQ(sum.timed, 2u);
  EXPECT_EQ(sum.of(Status::agrees), 1u);
  EXPECT_EQ(sum.of(Status::differs), 1u);
  EXPECT_EQ(sum.of(Status::lacks_features), 3u);
  ASSERT_TRUE(sum.trace_ratio && sum.whole_ratio);
  EXPECT_NEAR(*sum.trace_ratio, 1.0, 1e-12) << "4 and 1/4";
  EXPECT_NEAR(*sum.whole_ratio, 1.0, 1e-12) << "2 and 1/2";
  EXPECT_EQ(sum.slower_trace, 1u);
  EXPECT_EQ(sum.slower_whole, 1u);
}

TEST(CompareTotals, AFeatureCountsOnceAScene) {
  const std::vector<FeatureCount> missing = totals(some_records()).missing;
  ASSERT_EQ(missing.size(), 2u);
  for (const FeatureCount& count : missing) {
    EXPECT_EQ(count.scenes, 2u) << count.feature;
    EXPECT_EQ(count.alone, 1u) << count.feature;
  }
}

TEST(CompareTotals, OfNothingThereIsNoRatio) {
  const Totals sum = totals({});
  EXPECT_FALSE(sum.trace_ratio || sum.whole_ratio);
  EXPECT_EQ(to_text(sum), "0 scenes:\n");
}

TEST(CompareTotals, ATimeThatTheClockDoesNotSeeIsNoRatio) {
  EXPECT_FALSE(trace_ratio(rendered_record("quick", 1.0, 0.0)));
  EXPECT_EQ(totals(std::vector{rendered_record("quick", 1.0, 0.0)}).timed, 1u);
}

TEST(CompareTotals, AreTold) {
  const std::string text = to_text(totals(some_records()));
  EXPECT_NE(text.find("5 scenes: 1 agrees, 1 differs, 3 lack features"), std::string::npos) << text;
  EXPECT_NE(text.find("of 2 that both rendered"), std::string::npos) << text;
}

TEST(CompareKeptJson, GivesTheRecordBack) {
  for (const SceneRecord& record : some_records()) {
    const auto again = record_of(nlohmann::ordered_json::parse(text_of(to_json(record))));
    ASSERT_TRUE(again) << record.name;
    EXPECT_EQ(text_of(to_json(*again)), text_of(to_json(record)));
  }
  const auto equal = record_of(to_json(rendered_record("equal", 1.0, 1.0)));
  EXPECT_TRUE(std::isinf(equal->difference->psnr));
}

TEST(CompareKeptJson, WhatIsSomethingElseIsNothing) {
  nlohmann::ordered_json json = to_json(rendered_record("a", 1.0, 1.0));
  EXPECT_FALSE(record_of(nullptr));
  json["status"] = "agreed";
  EXPECT_FALSE(record_of(json));
  json["status"] = 3;
  EXPECT_FALSE(record_of(json));
}

TEST(CompareSweepJson, HasTotalsAndScenes) {
  const auto json = sweep_json(some_records());
  EXPECT_EQ(json["totals"]["status"]["lacks_features"], 3);
  ASSERT_EQ(json["scenes"].size(), 5u);
  EXPECT_EQ(json["scenes"][3]["name"], "lights/both");
}

TEST(CompareAgreement, HasALineForWhatWasRenderedAndNamesTheOthers) {
  const std::string page = agreement_page(some_records(), "firstlight compare --list x");
  EXPECT_NE(page.find("    firstlight compare --list x\n"), std::string::npos) << page;
  EXPECT_NE(page.find("| lack features | 3 |"), std::string::npos) << page;
  EXPECT_NE(page.find("| fast | agrees | 100.00 % | 4.00 | 2.00 |"), std::string::npos) << page;
  EXPECT_NE(page.find("| slow\\_one | differs | 50.00 % | 0.25 | 0.50 |"), std::string::npos) << page;
  EXPECT_NE(page.find("Lack features: foggy 1.\n"), std::string::npos) << page;
  EXPECT_NE(page.find("### lights\n\nLack features: both 2.\n"), std::string::npos) << page;
  EXPECT_NE(page.find("### (top)"), std::string::npos) << page;
}

TEST(CompareAgreement, NamesAreNoMarkdown) {
  const std::string page = agreement_page(std::vector{rendered_record("a|b<c>*\n# d", 1.0, 1.0)}, "x");
  EXPECT_NE(page.find("| a\\|b\\<c\\>\\* \\# d | agrees |"), std::string::npos) << page;
}

}  // namespace
}  // namespace firstlight::app::compare
