#include "render/shape/julia_fractal.h"
#include "tests/render/field_test_support.h"

namespace firstlight::render {
namespace {

using Algebra = JuliaFractalParameters::Algebra;

JuliaFractalParameters of(Algebra algebra, JuliaFunction function, const Vec4& parameter) {
  JuliaFractalParameters julia;
  julia.algebra = algebra;
  julia.function = function;
  julia.parameter = parameter;
  julia.most_iterations = 8;
  return julia;
}

/// At a crossing the ray changes sides.
void check_sides(const ShapePtr& shape, unsigned seed, int least) {
  RayRain rain(seed, 5.0, 1.0);
  int count = 0;
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = rain.next();
    for (const Crossing& crossing : met(shape, ray)) {
      ++count;
      ASSERT_NE(shape->inside(ray.at(crossing.depth - 3e-7)), shape->inside(ray.at(crossing.depth + 3e-7)));
    }
  }
  EXPECT_GT(count, least);
  EXPECT_GT(check_crossings(shape, seed + 1, 500), least / 20);
}

TEST(JuliaFractal, OfParameterZeroIsTheUnitBall) {
  for (const JuliaFunction function : {JuliaFunction::square, JuliaFunction::cube}) {
    JuliaFractalParameters julia = of(Algebra::quaternion, function, Vec4(0.0));
    julia.most_iterations = 9;
    const ShapePtr shape = make_julia_fractal(julia);
    const Ray ray = ray_to(Vec3(3, 4, 5), Vec3(0.1, 0.2, 0.1));
    ASSERT_FALSE(met(shape, ray).empty());
    for (const Crossing& crossing : met(shape, ray)) {
      EXPECT_NEAR(ray.at(crossing.depth).length(), 1.0, 1e-6);
      expect_near(shape->normal(ray.at(crossing.depth), crossing), ray.at(crossing.depth).normalized(), 1e-4);
    }
    EXPECT_TRUE(shape->inside(Vec3(0.5)));
    EXPECT_TRUE(shape->inverted()->inside(Vec3(0.6)));
  }
}

TEST(JuliaFractal, SidesChangeAtItsCrossings) {
  check_sides(make_julia_fractal(of(Algebra::quaternion, JuliaFunction::square, Vec4(-0.08, 0.1, -0.8, -0.03))), 1,
              100);
  check_sides(make_julia_fractal(of(Algebra::quaternion, JuliaFunction::cube, Vec4(-0.2, 0.6, 0.2, 0.2))), 2, 100);
  check_sides(make_julia_fractal(of(Algebra::hypercomplex, JuliaFunction::square, Vec4(-0.16, 0.16, 0.56, -0.5))), 3,
              20);
  check_sides(make_julia_fractal(of(Algebra::hypercomplex, JuliaFunction::reciprocal, Vec4(0.6, 0.2, 0.1, 0))), 4, 100);
}

TEST(JuliaFractal, IsPlacedWithItsCrossings) {
  const ShapePtr shape =
      make_julia_fractal(of(Algebra::quaternion, JuliaFunction::square, Vec4(-0.08, 0.1, -0.8, -0.03)));
  const ShapePtr moved = shape->placed(Transform::translation(Vec3(1, 2, 3)));
  const Ray ray = ray_to(Vec3(3, 4, 5), Vec3(0.1, 0.2, 0.1));
  const std::vector<double> found = depths(shape, ray);
  ASSERT_FALSE(found.empty());
  const Ray there{ray.origin + Vec3(1, 2, 3), ray.direction};
  expect_depths(moved, there, found, 1e-7);
  std::vector<Crossing> nearest;
  shape->nearest(ray, 0.0, 1e9, nearest);
  ASSERT_EQ(nearest.size(), 1u);
  EXPECT_EQ(nearest[0].depth, found[0]);
}

#ifdef FIRSTLIGHT_SANITIZED
constexpr int kRays = 30;
#else
constexpr int kRays = 300;
#endif

TEST(JuliaFractal, OfEveryFunctionIsMetSomewhere) {
  for (int i = 0; i <= static_cast<int>(JuliaFunction::power); ++i) {
    JuliaFractalParameters julia = of(Algebra::hypercomplex, static_cast<JuliaFunction>(i), Vec4(0.3, 0.2, 0.1, 0.05));
    julia.exponent = {2.5, 0.3};
    const ShapePtr shape = make_julia_fractal(julia);
    EXPECT_GT(check_crossings(shape, 5, kRays), 0) << i;
    EXPECT_NE(shape->inside(Vec3(0.1)), shape->inverted()->inside(Vec3(0.1)));
  }
}

TEST(JuliaFractal, OfAnyNumbersComesToAnEnd) {
  for (const double size : {0.0, 1e-300, 1e300}) {
    for (const Algebra algebra : {Algebra::quaternion, Algebra::hypercomplex}) {
      JuliaFractalParameters julia = of(algebra, JuliaFunction::cube, Vec4(size, size, 0, size));
      julia.precision = 1e300;
      julia.most_iterations = 3;
      julia.slice_distance = size;
      met(make_julia_fractal(julia), {Vec3(-5, 0.1, 0), Vec3(1, 0, 0)});
    }
  }
}

}  // namespace
}  // namespace firstlight::render
