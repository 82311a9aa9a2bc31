#include "render/shape/parametric.h"
#include "tests/render/field_test_support.h"

#include <numbers>

namespace firstlight::render {
namespace {

ParametricParameters sphere() {
  ParametricParameters p;
  p.functions = {formula([](double u, double v, double) { return std::sin(u) * std::cos(v); }),
                 formula([](double u, double v, double) { return std::sin(u) * std::sin(v); }),
                 formula([](double u, double, double) { return std::cos(u); })};
  p.high = Vec2(std::numbers::pi, 2.0 * std::numbers::pi);
  p.container = ContainerSphere{Vec3(0.0), 1.2};
  p.max_gradient = 1.1;
  p.accuracy = 0.01;
  return p;
}

TEST(Parametric, CrossingsLieNearTheSurface) {
  const ShapePtr shape = make_parametric(sphere());
  RayRain rain(1, 5.0, 0.7);
  int count = 0;
  for (int i = 0; i < 300; ++i) {
    const Ray ray = rain.next();
    for (const Crossing& crossing : met(shape, ray)) {
      ++count;
      const Vec3 p = ray.at(crossing.depth);
      ASSERT_NEAR(p.length(), 1.0, 0.15);  // rectangles are as small as the accuracy in u and v or along the ray
      const Vec2 uv = shape->uv(p, crossing);
      const Vec3 q(std::sin(uv.x) * std::cos(uv.y), std::sin(uv.x) * std::sin(uv.y), std::cos(uv.x));
      ASSERT_LT((q - p).length(), 0.3);
      ASSERT_GT(std::abs(shape->normal(p, crossing).dot(q)), 0.98);
    }
  }
  EXPECT_GT(count, 200);
  check_crossings(shape, 2, 300);
  check_first(shape, 3, 100);
}

TEST(Parametric, HasNoInside) {
  const ShapePtr shape = make_parametric(sphere());
  EXPECT_FALSE(shape->inside(Vec3(0.1)));
  EXPECT_FALSE(shape->inverted()->inside(Vec3(0.1)));
  EXPECT_FALSE(shape->inverted()->inside(Vec3(3)));
}

TEST(Parametric, WhatIsWorkedOutBeforeFindsTheSame) {
  ParametricParameters parameters = sphere();
  const ShapePtr plain = make_parametric(parameters);
  parameters.precompute_depth = 14;
  parameters.precompute = {true, false, true};
  const ShapePtr before = make_parametric(parameters);
  RayRain rain(4, 5.0, 0.7);
  for (int i = 0; i < 200; ++i) {
    const Ray ray = rain.next();
    const std::vector<double> a = depths(plain, ray);
    const std::vector<double> b = depths(before, ray);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 0.05);
  }
}

TEST(Parametric, OfAnyNumbersComesToAnEnd) {
  ParametricParameters parameters = sphere();
  const Ray ray{Vec3(-5, 0.1, 0), Vec3(1, 0, 0)};
  for (const double accuracy : {1e-300, -1.0, 0.0, 1e300}) {
    for (const double gradient : {0.0, -1.0, 1e300}) {
      parameters.accuracy = accuracy;
      parameters.max_gradient = gradient;
      met(make_parametric(parameters), ray);
    }
  }
  parameters = sphere();
  parameters.functions[1] = formula([](double, double, double) { return std::numeric_limits<double>::quiet_NaN(); });
  met(make_parametric(parameters), ray);
  parameters.functions[1] = formula([](double, double, double) { return 0.1; });
  parameters.functions[0] = parameters.functions[1];
  for (const Crossing& crossing : met(make_parametric(parameters), {Vec3(0.09, 0.09, -5), Vec3(0, 0, 1)})) {
    EXPECT_NEAR(make_parametric(parameters)->normal(Vec3(0.0), crossing).length(), 1.0, 1e-9);
  }
}

}  // namespace
}  // namespace firstlight::render
