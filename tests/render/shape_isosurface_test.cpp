#include "render/shape/isosurface.h"
#include "tests/render/field_test_support.h"

namespace firstlight::render {
namespace {

double ball(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z) - 0.9; }
double waves(double x, double y, double z) {
  return y - 0.3 * std::sin(7.0 * x) * std::cos(5.0 * z) + 0.1 * std::sin(31.0 * x);
}

IsosurfaceParameters of(Formula::Value value, double max_gradient = 1.1) {
  IsosurfaceParameters parameters;
  parameters.function = formula(std::move(value));
  parameters.max_gradient = max_gradient;
  parameters.max_trace = IsosurfaceParameters::kMostTraces;
  return parameters;
}

/// POV-Ray's rule as it is written: halves one after the other.
struct ByTheRule {
  std::function<double(double)> f;
  double accuracy;
  bool find(double begin, double at_begin, double end, double at_end, double climb, double length, double& root) const {
    if (length < accuracy) {
      root = end;
      return at_end < 0.0;
    }
    if (!(at_begin + at_end - climb < 0.0)) return false;
    const double half = 0.5 * length;
    const double middle = begin + half;
    const double at_middle = f(middle);
    return find(begin, at_begin, middle, at_middle, 0.5 * climb, half, root) ||
           find(middle, at_middle, end, at_end, 0.5 * climb, half, root);
  }
};

TEST(Isosurface, OfABallIsOne) {
  IsosurfaceParameters parameters = of(ball);
  parameters.accuracy = 1e-7;
  const ShapePtr shape = make_isosurface(parameters);
  expect_depths(shape, {Vec3(0, 0, -5), Vec3(0, 0, 1)}, {4.1, 5.9}, 2e-7);
  check_closed_solid(shape, 1);
  check_closed_solid(shape->placed(uneven_placement()), 2);
  check_placement(shape, uneven_placement(), 3);
  check_first(shape, 4);
  expect_near(shape->normal(Vec3(0.9, 0, 0), {}), Vec3(1, 0, 0), 1e-6);
}

TEST(Isosurface, IsMetWherePovRaysRuleFindsIt) {
  for (const double gradient : {9.0, 4.0, 1.5, 0.7}) {  // the function's is about 5: the last ones leave holes
    IsosurfaceParameters parameters = of(waves, gradient);
    parameters.open = true;
    const ShapePtr shape = make_isosurface(parameters);
    const Box3 box = shape->bounds();
    RayRain rain(static_cast<unsigned>(gradient * 10.0), 3.0, 1.0);
    int count = 0;
    for (int i = 0; i < 1500; ++i) {
      const Ray ray = rain.next();
      const ContainedRays contained(parameters.container, Transform(), alone(ray), 1);
      const double begin = contained.begin[0], end = contained.end[0];
      if (contained.met == 0 || box.intersects(ray.origin) || end - begin < parameters.accuracy) continue;
      const auto f = [&](double t) {
        const Vec3 p = ray.at(t);
        return waves(p.x, p.y, p.z);
      };
      const double sign = f(begin) < 0.0 ? -1.0 : 1.0;
      const ByTheRule rule{[&](double t) { return sign * f(t); }, parameters.accuracy};
      const double length = end - begin;
      double root = 0.0;
      const bool is_met = rule.find(begin, sign * f(begin), end, sign * f(end),
                                    gradient * ray.direction.length() * length, length, root);
      const std::vector<double> found = depths(shape, ray);
      ASSERT_EQ(!found.empty(), is_met);
      if (is_met) {
        ASSERT_EQ(found.front(), root);
        ++count;
      }
    }
    EXPECT_GT(count, 100);
  }
}

TEST(Isosurface, CrossingsAreWhereTheSidesMeet) {
  const ShapePtr shape = make_isosurface(of(waves, 9.0));
  RayRain rain(5, 3.0, 0.8);
  int count = 0;
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = rain.next();
    for (const Crossing& crossing : met(shape, ray)) {
      if (crossing.face != 0) continue;
      ++count;
      const Vec3 p = ray.at(crossing.depth);
      const Vec3 before = ray.at(crossing.depth - 0.001);
      ASSERT_LT(waves(p.x, p.y, p.z) * waves(before.x, before.y, before.z), 1e-3);
      ASSERT_LT(std::abs(waves(p.x, p.y, p.z)), 0.006);
    }
  }
  EXPECT_GT(count, 300);
  check_crossings(shape, 6);
}

TEST(Isosurface, EndsAtItsContainerUnlessItIsOpen) {
  IsosurfaceParameters parameters = of([](double, double y, double) { return y; });
  parameters.container = ContainerBox{Vec3(-1, -1, -1), Vec3(1, 2, 1)};
  const ShapePtr closed = make_isosurface(parameters);
  const Ray level{Vec3(-5, -0.5, 0), Vec3(1, 0, 0)};
  expect_depths(closed, level, {4.0}, 1e-9);  // where it leaves the container, as POV-Ray has it
  expect_normal(closed, level, 0, Vec3(-1, 0, 0));
  expect_depths(closed, {Vec3(0, -0.5, 0), Vec3(1, 0, 0)}, {1.0}, 1e-9);
  expect_depths(closed, {Vec3(0, -5, 0), Vec3(0, 1, 0)}, {4.0, 5.0}, 1e-3);
  parameters.open = true;
  const ShapePtr open = make_isosurface(parameters);
  expect_depths(open, level, {});
  expect_depths(open, {Vec3(0, -5, 0), Vec3(0, 1, 0)}, {5.0}, 1e-3);
  parameters.open = false;
  parameters.container = ContainerSphere{Vec3(0.0), 1.0};
  const ShapePtr round = make_isosurface(parameters);
  expect_normal(round, {Vec3(0, -5, 0), Vec3(0, 1, 0)}, 0, Vec3(0, -1, 0));
  EXPECT_FALSE(round->inside(Vec3(0, -1.1, 0)));
  EXPECT_TRUE(round->inside(Vec3(0, -0.9, 0)));
  EXPECT_FALSE(round->inside(Vec3(0, 0.1, 0)));
  check_first(round, 7);
  check_first(open, 8);
}

TEST(Isosurface, HasAsManyCrossingsAsItMay) {
  IsosurfaceParameters parameters = of([](double x, double, double) { return std::sin(12.0 * x); }, 13.0);
  const Ray ray{Vec3(-5, 0.2, 0.1), Vec3(1, 0, 0)};
  EXPECT_EQ(depths(make_isosurface(parameters), ray).size(), 7u);
  parameters.max_trace = 3;
  EXPECT_EQ(depths(make_isosurface(parameters), ray).size(), 3u);
  parameters.max_trace = 1;
  EXPECT_EQ(depths(make_isosurface(parameters), ray).size(), 1u);
}

TEST(Isosurface, FindsItsGradientWhereThatIsLeftOpen) {
  const auto steep = [](double x, double y, double z) { return 20.0 * ball(x, y, z) + std::sin(30.0 * y); };
  IsosurfaceParameters parameters = of(steep, 1.0);
  const auto count = [](const IsosurfaceParameters& p) { return check_crossings(make_isosurface(p), 9); };
  const int with_too_small = count(parameters);
  parameters.evaluate = std::array<double, 3>{5.0, 1.2, 0.95};
  const int with_found = count(parameters);
  parameters.evaluate.reset();
  parameters.max_gradient = 60.0;
  const int with_large = count(parameters);
  EXPECT_LT(with_too_small, with_large);
  EXPECT_NEAR(with_found, with_large, with_large / 50);
}

TEST(Isosurface, OfAnyFunctionComesToAnEnd) {
  const auto nan = [](double, double, double) { return std::numeric_limits<double>::quiet_NaN(); };
  const auto zero = [](double, double, double) { return 0.0; };
  const auto endless = [](double x, double, double) { return 1.0 / x; };
  const auto huge = [](double x, double, double) { return 1e300 * x; };
  for (const Formula::Value& value :
       {Formula::Value(nan), Formula::Value(zero), Formula::Value(endless), Formula::Value(huge)}) {
    for (const double accuracy : {1e-3, 1e-300, 1e300}) {
      IsosurfaceParameters parameters = of(value, accuracy < 1e-3 ? 1e-9 : 1e9);
      parameters.accuracy = accuracy;
      const ShapePtr shape = make_isosurface(parameters);
      for (const Crossing& crossing : met(shape, {Vec3(-3, 0.1, 0.2), Vec3(1, 0, 0)})) {
        EXPECT_NEAR(shape->normal(Vec3(0, 0.1, 0.2), crossing).length(), 1.0, 1e-9);
      }
      shape->inside(Vec3(0.1));
    }
  }
}

}  // namespace
}  // namespace firstlight::render
