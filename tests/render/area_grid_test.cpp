#include "render/light/area_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

Light area_of(int size1, int size2) {
  Light light;
  light.position = {1.0, 5.0, 2.0};
  light.area = AreaLight{{4.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, size1, size2};
  return light;
}

void expect_place(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).length(), 1e-12) << a << " is not " << b; }

TEST(AreaGrid, HasItsCornersAtHalfTheAxes) {
  const Light light = area_of(3, 5);
  const AreaGrid grid(light, Vec3(0.0), AreaGrid::Use::shadow);
  expect_place(grid.place(0, 0), {-1.0, 5.0, 1.0});
  expect_place(grid.place(2, 0), {3.0, 5.0, 1.0});
  expect_place(grid.place(1, 2), {1.0, 5.0, 2.0});
  expect_place(grid.place(2, 4), {3.0, 5.0, 3.0});
}

TEST(AreaGrid, OneRowLiesInTheMiddle) {
  const Light light = area_of(1, 2);
  const AreaGrid grid(light, Vec3(0.0), AreaGrid::Use::shadow);
  expect_place(grid.place(0, 0), {1.0, 5.0, 1.0});
  expect_place(grid.place(0, 1), {1.0, 5.0, 3.0});
}

TEST(AreaGrid, OrientedOnesFaceThePointAndAreSquare) {
  Light light = area_of(2, 2);
  light.orient = true;
  for (const Vec3& point : {Vec3(1.0, 0.0, 2.0), Vec3(1.0, 5.0, -7.0), Vec3(-3.0, 1.0, 4.0)}) {
    const AreaGrid grid(light, point, AreaGrid::Use::shadow);
    const Vec3 side1 = grid.place(1, 0) - grid.place(0, 0);
    const Vec3 side2 = grid.place(0, 1) - grid.place(0, 0);
    const Vec3 way = light.position - point;
    EXPECT_NEAR(side1.length(), 4.0, 1e-12);
    EXPECT_NEAR(side2.length(), 4.0, 1e-12);
    EXPECT_NEAR(side1.dot(way), 0.0, 1e-12);
    EXPECT_NEAR(side2.dot(way), 0.0, 1e-12);
    EXPECT_NEAR(side1.dot(side2), 0.0, 1e-12);
  }
}

TEST(AreaGrid, CircularOnesHaveNoCorners) {
  Light light = area_of(5, 5);
  light.circular = true;
  light.area->axis2 = {0.0, 0.0, 4.0};
  const AreaGrid grid(light, Vec3(0.0), AreaGrid::Use::shadow);
  for (const int corner : {0, 4}) EXPECT_NEAR((grid.place(corner, corner) - light.position).length(), 2.0, 0.01);
  EXPECT_LT((grid.place(2, 2) - light.position).length(), 0.01);
}

TEST(AreaGrid, JitterIsWithinHalfAStepAndOfThePoint) {
  Light light = area_of(3, 3);
  light.jitter = true;
  const Light still = area_of(3, 3);
  std::set<std::pair<double, double>> places;
  for (int i = 0; i < 100; ++i) {
    const Vec3 point(0.1 * i, 0.0, 0.0);
    const AreaGrid grid(light, point, AreaGrid::Use::shadow);
    const Vec3 gap = grid.place(1, 2) - AreaGrid(still, point, AreaGrid::Use::shadow).place(1, 2);
    EXPECT_LE(std::abs(gap.x), 1.0);
    EXPECT_LE(std::abs(gap.z), 0.5);
    places.insert({gap.x, gap.z});
    expect_place(AreaGrid(light, point, AreaGrid::Use::shadow).place(1, 2), grid.place(1, 2));
    EXPECT_NE(AreaGrid(light, point, AreaGrid::Use::illumination).place(1, 2), grid.place(1, 2));
  }
  EXPECT_EQ(places.size(), 100u);
}

/// How much each point counts when all rectangles are cut as far as they can be.
std::map<std::pair<int, int>, double> weights_of(int size1, int size2) {
  std::map<std::pair<int, int>, double> weights;
  std::vector<std::pair<AreaRectangle, double>> waiting{{{0, 0, size1 - 1, size2 - 1}, 1.0}};
  while (!waiting.empty()) {
    const auto [rectangle, weight] = waiting.back();
    waiting.pop_back();
    if (!rectangle.has_quarters()) {
      for (const auto& [u, v] : rectangle.corners()) weights[{u, v}] += 0.25 * weight;
      continue;
    }
    const AreaQuarters quarters = quarters_of(rectangle);
    for (std::size_t i = 0; i < quarters.size; ++i) waiting.push_back({quarters.of[i], 0.25 * weight * quarters.times});
  }
  return weights;
}

TEST(AreaRectangle, QuartersReachAllPointsAndAddUp) {
  for (const auto& [size1, size2] : {std::pair(1, 1), {1, 4}, {3, 3}, {5, 5}, {6, 3}, {9, 2}, {1, 1000}}) {
    const auto weights = weights_of(size1, size2);
    EXPECT_EQ(weights.size(), static_cast<std::size_t>(size1 * size2));
    double sum = 0.0;
    for (const auto& [point, weight] : weights) sum += weight;
    EXPECT_NEAR(sum, 1.0, 1e-9);
  }
}

TEST(AreaRectangle, MiddlePointsOfOddGridsCountDouble) {
  const auto weights = weights_of(3, 3);
  EXPECT_EQ(weights.at({0, 0}), 1.0 / 16);
  EXPECT_EQ(weights.at({1, 0}), 2.0 / 16);
  EXPECT_EQ(weights.at({1, 1}), 4.0 / 16);
}

TEST(AreaRectangle, CornersDifferByTheSumOfTheirChannels) {
  const Rgb white(1.0f);
  EXPECT_FALSE(differ({white, white, white, white}));
  EXPECT_FALSE(differ({white, white, white, white - Rgb(0.03f)}));
  EXPECT_TRUE(differ({white, white, white, white - Rgb(0.04f)}));
  EXPECT_FALSE(differ({white, white - Rgb(0.03f), white - Rgb(0.03f), white - Rgb(0.06f)}));
}

TEST(LightKinds, EachHasAScene) {
  constexpr std::string_view kKinds[] = {
#define LIGHT(kind, beam, parallel, radius, falloff) #kind,
#include "render/light/lights.def"
#undef LIGHT
  };
  const auto folder = std::filesystem::path(FIRSTLIGHT_SOURCE_DIR) / "testscenes" / "lights";
  for (const std::string_view kind : kKinds) {
    for (const std::string& scene : {std::string(kind), "parallel_" + std::string(kind)}) {
      if (scene == "parallel_point") continue;  // that is `parallel`
      EXPECT_TRUE(std::filesystem::exists(folder / (scene + ".pov"))) << scene;
    }
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "parallel.pov"));
}

}  // namespace
}  // namespace firstlight::render
