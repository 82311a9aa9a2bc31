#include "app/study/plot.h"

#include <gtest/gtest.h>

namespace firstlight::app {
namespace {

TEST(Plot, MarksAreRoundNumbers) {
  EXPECT_EQ(axis_marks(1.0, 5), (std::vector{0.0, 0.2, 0.4, 0.2 * 3, 0.8, 1.0}));
  EXPECT_EQ(axis_marks(7.0, 4), (std::vector{0.0, 2.0, 4.0, 6.0}));
  EXPECT_EQ(axis_marks(1300.0, 3), (std::vector{0.0, 500.0, 1000.0}));
  EXPECT_EQ(axis_marks(0.0, 5), (std::vector{0.0}));
}

TEST(Plot, NumbersAreShort) {
  EXPECT_EQ(axis_number(0.25, Plot::Numbers::plain), "0.25");
  EXPECT_EQ(axis_number(1500.0, Plot::Numbers::plain), "1500");
  EXPECT_EQ(axis_number(20'000.0, Plot::Numbers::plain), "20 k");
  EXPECT_EQ(axis_number(2.5e6, Plot::Numbers::plain), "2.5 M");
  EXPECT_EQ(axis_number(0.2 * 3, Plot::Numbers::percent), "60 %");
  EXPECT_EQ(axis_number(0.0001, Plot::Numbers::percent), "0.01 %");
}

Plot one_line(std::vector<CurvePoint> points) {
  Plot plot;
  plot.title = "t";
  plot.width = 180;   // the frame is 100 wide
  plot.height = 158;  // and 100 high
  plot.lines = {{"a < b", 3, std::move(points)}};
  return plot;
}

TEST(Plot, LinesFillTheFrame) {
  const std::string svg = to_svg(one_line({{0.0, 4.0}, {1.0, 1.0}, {2.0, 0.0}}));
  EXPECT_NE(svg.find("class=\"line line3\" points=\"64.0,12.0 114.0,87.0 164.0,112.0 \""), std::string::npos) << svg;
  EXPECT_NE(svg.find("<title>a &lt; b</title>"), std::string::npos);
}

TEST(Plot, LogarithmicLinesLieOnTheFloorBelowTheLeast) {
  Plot plot = one_line({{0.0, 1.0}, {1.0, 0.1}, {2.0, 0.0}});
  plot.y_scale = Plot::Scale::logarithmic;
  plot.y_least = 0.01;
  const std::string svg = to_svg(plot);
  EXPECT_NE(svg.find("points=\"64.0,12.0 114.0,62.0 164.0,112.0 \""), std::string::npos) << svg;
}

TEST(Plot, GivenEndsOfTheAxesRule) {
  Plot plot = one_line({{0.0, 1.0}, {1.0, 9.0}});
  plot.x_most = 2.0;
  plot.y_most = 2.0;
  EXPECT_NE(to_svg(plot).find("points=\"64.0,62.0 114.0,12.0 \""), std::string::npos) << "what is too high is cut off";
}

TEST(Plot, LinesOfNothingAreDrawnAllTheSame) {
  EXPECT_NE(to_svg(one_line({{0.0, 0.0}})).find("points=\"64.0,112.0 \""), std::string::npos);
  EXPECT_NE(to_svg(one_line({})).find("points=\"\""), std::string::npos);
}

}  // namespace
}  // namespace firstlight::app
