#include "render/shape/sphere_sweep.h"
#include "tests/render/field_test_support.h"

#include <random>

namespace firstlight::render {
namespace {

using Spline = SphereSweepParameters::Spline;
using Ball = SphereSweepParameters::Ball;

SphereSweepParameters random_sweep(Spline spline, std::size_t count, unsigned seed) {
  RayRain rain(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.15, 0.5);
  SphereSweepParameters sweep;
  sweep.spline = spline;
  for (std::size_t i = 0; i < count; ++i) sweep.balls.push_back(Ball{rain.point(1.2), radius(random)});
  return sweep;
}

/// The ball at u in the piece that begins at ball `i`, by the splines' usual formulas.
Ball ball_at(const SphereSweepParameters& sweep, std::size_t i, double u) {
  std::array<double, 4> weight{};
  if (sweep.spline == Spline::linear) {
    weight = {1.0 - u, u, 0.0, 0.0};
  } else if (sweep.spline == Spline::cubic) {
    weight = {0.5 * (-u * u * u + 2 * u * u - u), 0.5 * (3 * u * u * u - 5 * u * u + 2),
              0.5 * (-3 * u * u * u + 4 * u * u + u), 0.5 * (u * u * u - u * u)};
  } else {
    weight = {(1 - u) * (1 - u) * (1 - u) / 6, (3 * u * u * u - 6 * u * u + 4) / 6,
              (-3 * u * u * u + 3 * u * u + 3 * u + 1) / 6, u * u * u / 6};
  }
  Ball sum;
  for (std::size_t k = 0; k < (sweep.spline == Spline::linear ? 2u : 4u); ++k) {
    sum.center += sweep.balls[i + k].center * weight[k];
    sum.radius += sweep.balls[i + k].radius * weight[k];
  }
  return sum;
}

/// Balls that lie so closely along the sweep that they stand for it.
std::vector<Ball> balls_along(const SphereSweepParameters& sweep) {
  const std::size_t pieces = sweep.balls.size() - (sweep.spline == Spline::linear ? 1 : 3);
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < pieces; ++i) {
    constexpr int kSteps = 100;
    for (int k = 0; k <= kSteps; ++k) balls.push_back(ball_at(sweep, i, static_cast<double>(k) / kSteps));
  }
  return balls;
}

/// How far a point is from the surface of all balls together: below 0 inside.
double distance(const std::vector<Ball>& balls, const Vec3& p) {
  double least = 1e9;
  for (const Ball& ball : balls) least = std::min(least, (p - ball.center).length() - ball.radius);
  return least;
}

/// Compares the first and the last crossing of a placed sweep with those of the sweep. Between them, where parts
/// overlap, POV-Ray's counting hangs on rounding.
void check_placed(const ShapePtr& shape, unsigned seed) {
  RayRain rain(seed);
  const Transform transform = uneven_placement();
  const ShapePtr moved = shape->placed(transform);
  for (int i = 0; i < 300; ++i) {
    const Ray ray = rain.next();
    const Ray world{transform.point(ray.origin), transform.direction(ray.direction).normalized()};
    const double stretch = transform.direction(ray.direction).length();
    const std::vector<double> before = depths(shape, ray);
    const std::vector<double> after = depths(moved, world);
    ASSERT_EQ(before.empty(), after.empty());
    if (before.empty()) continue;
    ASSERT_NEAR(before.front() * stretch, after.front(), 1e-6);
    ASSERT_NEAR(before.back() * stretch, after.back(), 1e-6);
    const Vec3 p = rain.point(2.0);
    ASSERT_EQ(shape->inside(p), moved->inside(transform.point(p)));
  }
}

void check_sweep(const SphereSweepParameters& sweep, unsigned seed) {
  const ShapePtr shape = make_sphere_sweep(sweep);
  const std::vector<Ball> balls = balls_along(sweep);
  RayRain rain(seed);
  int count = 0;
  int off = 0;
  for (int i = 0; i < 200; ++i) {
    const Ray ray = rain.next();
    std::vector<Crossing> all = met(shape, ray);
    std::sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) { return a.depth < b.depth; });
    if (all.empty()) {
      for (double t = 5.0; t < 15.0; t += 0.25) ASSERT_GT(distance(balls, ray.at(t)), -0.02);
      continue;
    }
    for (const Crossing& crossing : {all.front(), all.back()}) {
      ++count;
      const Vec3 p = ray.at(crossing.depth);
      ASSERT_LT(std::abs(distance(balls, p)), 0.003);
      // Normals point the way in which the distance grows, but where two parts meet.
      const Vec3 n = shape->normal(p, crossing);
      off += distance(balls, p + n * 0.01) > 0.005 ? 0 : 1;
    }
  }
  EXPECT_GT(count, 20);
  EXPECT_LE(off, 1 + count / 50);
  check_crossings(shape, seed + 1, 500);
  check_first(shape, seed + 2, 300);
  check_placed(shape, seed + 3);
}

TEST(SphereSweep, OfOneRadiusIsACapsule) {
  SphereSweepParameters sweep;
  sweep.balls = {Ball{Vec3(0, -1, 0), 0.5}, Ball{Vec3(0, 1, 0), 0.5}};
  const ShapePtr shape = make_sphere_sweep(sweep);
  expect_depths(shape, {Vec3(-5, 0.3, 0), Vec3(1, 0, 0)}, {4.5, 5.5});
  expect_depths(shape, {Vec3(0, -5, 0), Vec3(0, 1, 0)}, {3.5, 6.5});
  expect_normal(shape, {Vec3(-5, 0.3, 0), Vec3(1, 0, 0)}, 0, Vec3(-1, 0, 0));
  expect_normal(shape, {Vec3(0, -5, 0), Vec3(0, 1, 0)}, 1, Vec3(0, 1, 0));
  EXPECT_TRUE(shape->inside(Vec3(0.4, 0, 0)));
  EXPECT_FALSE(shape->inside(Vec3(0.6, 0, 0)));
  EXPECT_TRUE(shape->inverted()->inside(Vec3(0.6, 0, 0)));
  expect_near(shape->bounds().max, Vec3(0.5, 1.5, 0.5), 1e-6);
}

TEST(SphereSweep, OfLinesIsMetOnItsSurface) {
  for (unsigned seed = 1; seed < 5; ++seed) check_sweep(random_sweep(Spline::linear, 2 + seed, seed), seed);
}

TEST(SphereSweep, OfCubicCurvesIsMetOnItsSurface) {
  for (unsigned seed = 11; seed < 15; ++seed) check_sweep(random_sweep(Spline::cubic, seed - 7, seed), seed);
}

TEST(SphereSweep, OfBSplinesIsMetOnItsSurface) {
  for (unsigned seed = 21; seed < 25; ++seed) check_sweep(random_sweep(Spline::b_spline, seed - 17, seed), seed);
}

TEST(SphereSweep, OfManyPiecesIsMetOnItsSurface) {
  SphereSweepParameters sweep;
  sweep.spline = Spline::b_spline;
  for (int i = 0; i < 40; ++i) {
    const double a = 0.4 * i;
    sweep.balls.push_back(Ball{Vec3(std::cos(a), 0.06 * i - 1.2, std::sin(a)), 0.2});
  }
  check_sweep(sweep, 31);
}

TEST(SphereSweep, InAPlaneIsMetByRaysAcrossIt) {
  for (const Spline spline : {Spline::linear, Spline::cubic, Spline::b_spline}) {
    for (const double slope : {0.0, 1e-12, 1e-8, 1e-5, 1e-3}) {
      SphereSweepParameters sweep = random_sweep(spline, 6, 41);
      for (Ball& ball : sweep.balls) ball.center.z = 0.0;
      const ShapePtr shape = make_sphere_sweep(sweep);
      const std::vector<Ball> balls = balls_along(sweep);
      RayRain rain(42);
      for (int i = 0; i < 200; ++i) {
        Vec3 target = rain.point(1.3);
        target.z = 0.0;
        if (distance(balls, target) > -0.01) continue;
        const Vec3 direction = Vec3(slope, 2.0 * slope, 1.0).normalized();
        ASSERT_FALSE(depths(shape, {target - direction * 5.0, direction}).empty()) << slope;
      }
    }
  }
}

TEST(SphereSweep, HasPovRaysBox) {
  SphereSweepParameters sweep;
  sweep.spline = Spline::cubic;
  sweep.balls = {Ball{Vec3(0, -9, 0), 0.1}, Ball{Vec3(-1, 0, 0), 0.5}, Ball{Vec3(1, 0, 0), 0.5}, Ball{Vec3(0, 9, 0), 0.1}};
  const ShapePtr shape = make_sphere_sweep(sweep);
  expect_near(shape->given_bounds().min, Vec3(-2, -9.2, -1));
  EXPECT_GT(shape->bounds().min.y, -3.0);
}

TEST(SphereSweep, OfEqualBallsOrHugeOnesComesToAnEnd) {
  for (const double size : {0.0, 1e-200, 1.0, 1e100, 1e200}) {
    for (const Spline spline : {Spline::linear, Spline::cubic, Spline::b_spline}) {
      SphereSweepParameters sweep;
      sweep.spline = spline;
      for (int i = 0; i < 4; ++i) sweep.balls.push_back(Ball{Vec3(i == 3 ? size : 0.0, 0.0, 0.0), i == 2 ? -size : size});
      const ShapePtr shape = make_sphere_sweep(sweep);
      met(shape, {Vec3(-5, 0.1, 0), Vec3(1, 0, 0)});
      shape->inside(Vec3(0.1));
    }
  }
}

}  // namespace
}  // namespace firstlight::render
