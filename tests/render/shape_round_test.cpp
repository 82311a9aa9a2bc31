#include "tests/render/shape_test_support.h"

#include "render/shape/sphere.h"

namespace firstlight::render {
namespace {

TEST(Sphere, IsMetTwiceWithOutwardNormals) {
  const ShapePtr sphere = make_sphere(Vec3(1, 0, 0), 2.0);
  const Ray ray{Vec3(1, 0, -10), Vec3(0, 0, 1)};
  expect_depths(sphere, ray, {8.0, 12.0});
  expect_normal(sphere, ray, 0, Vec3(0, 0, -1));
  expect_normal(sphere, ray, 1, Vec3(0, 0, 1));
}

TEST(Sphere, FromInsideIsMetOnce) { expect_depths(make_sphere(Vec3(0.0), 2.0), {Vec3(1, 0, 0), Vec3(1, 0, 0)}, {1.0}); }

TEST(Sphere, BehindTheOriginIsNotMet) {
  expect_depths(make_sphere(Vec3(0.0), 2.0), {Vec3(3, 0, 0), Vec3(1, 0, 0)}, {});
}

TEST(Sphere, OfNoRadiusIsNothing) {
  const ShapePtr nothing = make_sphere(Vec3(0.0), 0.0);
  expect_depths(nothing, {Vec3(0, 0, -5), Vec3(0, 0, 1)}, {});
  EXPECT_FALSE(nothing->inside(Vec3(0.0)));
}

TEST(Sphere, IsAClosedSolid) {
  check_closed_solid(make_sphere(Vec3(0.2, 0.3, -0.1), 1.3), 1);
  check_closed_solid(make_sphere(Vec3(0.2, 0.3, -0.1), 1.3)->placed(uneven_placement()), 2);
}

TEST(Sphere, StaysASphereUnderSimilarities) {
  const ShapePtr sphere = make_sphere(Vec3(1, 2, 3), 0.5);
  const Transform similar = Transform::scaling(Vec3(-3, 3, 3))
                                .then(Transform::rotation(Vec3(10, 20, 30)))
                                .then(Transform::translation(Vec3(1, 1, 1)));
  const ShapePtr moved = sphere->placed(similar);
  ASSERT_NE(dynamic_cast<const Sphere*>(moved.get()), nullptr);
  EXPECT_EQ(dynamic_cast<const Sphere*>(sphere->placed(uneven_placement()).get()), nullptr);
  check_placement(sphere, similar, 3);
  check_placement(sphere, uneven_placement(), 4);
}

TEST(Ellipsoid, HasItsHalfAxesAndNormals) {
  const ShapePtr egg = make_sphere(Vec3(0.0), 1.0)->placed(Transform::scaling(Vec3(1, 2, 3)));
  expect_depths(egg, {Vec3(0, -10, 0), Vec3(0, 1, 0)}, {8.0, 12.0});
  expect_depths(egg, {Vec3(0, 0, -10), Vec3(0, 0, 1)}, {7.0, 13.0});
  const double c = std::sqrt(0.5);
  const Ray ray{Vec3(-10, 2 * c, 0), Vec3(1, 0, 0)};
  expect_normal(egg, ray, 0, Vec3(-1, 0.5, 0).normalized());
  expect_near(egg->bounds().max, Vec3(1, 2, 3));
}

TEST(Torus, IsMetFourTimesThroughItsAxisPlane) {
  const ShapePtr torus = make_torus(2.0, 0.5);
  expect_depths(torus, {Vec3(-10, 0, 0), Vec3(1, 0, 0)}, {7.5, 8.5, 11.5, 12.5});
  expect_depths(torus, {Vec3(0, -10, 0), Vec3(0, 1, 0)}, {});
  expect_depths(torus, {Vec3(2, -10, 0), Vec3(0, 1, 0)}, {9.5, 10.5});
  expect_normal(torus, {Vec3(-10, 0, 0), Vec3(1, 0, 0)}, 1, Vec3(1, 0, 0));
}

TEST(Torus, IsAClosedSolid) {
  check_closed_solid(make_torus(1.2, 0.4), 5);
  check_closed_solid(make_torus(1.2, 0.4)->placed(uneven_placement()), 6);
  check_placement(make_torus(1.2, 0.4), uneven_placement(), 7);
}

TEST(Torus, CrossingsLieOnTheTubeEvenFromFarAwayAndWhenThin) {
  for (const double minor : {0.5, 0.02}) {
    const ShapePtr torus = make_torus(1.0, minor);
    RayRain rain(8, 1e4, 1.1);
    int count = 0;
    for (int i = 0; i < 20000; ++i) {
      const Ray ray = rain.next();
      for (const double depth : depths(torus, ray)) {
        ++count;
        const Vec3 p = ray.at(depth);
        const double tube = std::hypot(std::hypot(p.x, p.z) - 1.0, p.y);
        ASSERT_NEAR(tube, minor, 1e-8);
      }
    }
    ASSERT_GT(count, 100);
  }
}

TEST(Torus, WithATubeWiderThanItsRingHasAnInnerSheet) {
  // The tube's circle around x = 1 with radius 2 also reaches x = -1.
  expect_depths(make_torus(1.0, 2.0), {Vec3(-10, 0, 0), Vec3(1, 0, 0)}, {7.0, 9.0, 11.0, 13.0});
}

TEST(Torus, DoesNotMeetTheRayThatStartsOnIt) {
  const ShapePtr torus = make_torus(2.0, 0.5);
  RayRain rain(9);
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = rain.next();
    for (const Crossing& c : met(torus, ray)) {
      const Vec3 p = ray.at(c.depth);
      const Vec3 n = torus->normal(p, c);
      for (const double depth : depths(torus, {p, n})) ASSERT_GT(depth, 0.1);
    }
  }
}

}  // namespace
}  // namespace firstlight::render
