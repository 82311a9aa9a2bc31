#include "tests/render/shape_test_support.h"

namespace firstlight::render {
namespace {

const Vec3 kBase(0, 0, 0);
const Vec3 kCap(0, 4, 0);

TEST(Cylinder, HasASideAndTwoCaps) {
  const ShapePtr cylinder = make_cylinder(kBase, kCap, 1.0, false);
  expect_depths(cylinder, {Vec3(-5, 2, 0), Vec3(1, 0, 0)}, {4.0, 6.0});
  expect_normal(cylinder, {Vec3(-5, 2, 0), Vec3(1, 0, 0)}, 0, Vec3(-1, 0, 0));
  expect_depths(cylinder, {Vec3(0.5, -5, 0), Vec3(0, 1, 0)}, {5.0, 9.0});
  expect_normal(cylinder, {Vec3(0.5, -5, 0), Vec3(0, 1, 0)}, 0, Vec3(0, -1, 0));
  expect_normal(cylinder, {Vec3(0.5, -5, 0), Vec3(0, 1, 0)}, 1, Vec3(0, 1, 0));
}

TEST(Cylinder, OpenHasNoCaps) {
  const ShapePtr tube = make_cylinder(kBase, kCap, 1.0, true);
  expect_depths(tube, {Vec3(0.5, -5, 0), Vec3(0, 1, 0)}, {});
  expect_depths(tube, {Vec3(-5, 2, 0), Vec3(1, 0, 0)}, {4.0, 6.0});
  EXPECT_TRUE(tube->inside(Vec3(0, 2, 0)));
  EXPECT_FALSE(tube->inside(Vec3(0, 5, 0)));
}

TEST(Cylinder, IsAClosedSolidAlongAnyAxis) {
  unsigned seed = 1;
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0.3, -1, 0.7), Vec3(0, 0, 1 + 1e-13)}) {
    check_closed_solid(make_cylinder(-axis, axis, 0.8, false), seed++);
    check_closed_solid(make_cylinder(-axis, axis, 0.8, false)->placed(uneven_placement()), seed++);
  }
  check_placement(make_cylinder(kBase, kCap, 1.0, false), uneven_placement(), seed);
}

TEST(Cylinder, WithoutHeightOrRadiusIsNothing) {
  for (const ShapePtr& nothing : {make_cylinder(kBase, kBase, 1.0, false), make_cylinder(kBase, kCap, 0.0, false)}) {
    expect_depths(nothing, {Vec3(-5, 0, 0), Vec3(1, 0, 0)}, {});
    EXPECT_FALSE(nothing->inside(kBase));
  }
}

TEST(Cone, NarrowsToItsTip) {
  const ShapePtr cone = make_cone(kBase, 2.0, kCap, 0.0, false);
  expect_depths(cone, {Vec3(-5, 2, 0), Vec3(1, 0, 0)}, {4.0, 6.0});
  expect_normal(cone, {Vec3(-5, 2, 0), Vec3(1, 0, 0)}, 0, Vec3(-2, 1, 0).normalized());
  expect_depths(cone, {Vec3(1, -5, 0), Vec3(0, 1, 0)}, {5.0, 7.0});
  expect_normal(cone, {Vec3(1, -5, 0), Vec3(0, 1, 0)}, 0, Vec3(0, -1, 0));
  expect_near(cone->bounds().min, Vec3(-2, 0, -2));
  expect_near(cone->bounds().max, Vec3(2, 4, 2));
}

TEST(Cone, IsTheSameEitherWayRound) {
  const ShapePtr one = make_cone(kBase, 2.0, kCap, 0.5, false);
  const ShapePtr other = make_cone(kCap, 0.5, kBase, 2.0, false);
  RayRain rain(3);
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = rain.next();
    ASSERT_EQ(depths(one, ray), depths(other, ray));
  }
}

TEST(Cone, IsAClosedSolid) {
  check_closed_solid(make_cone(Vec3(0.1, -1, 0), 1.2, Vec3(0.3, 1, 0.4), 0.3, false), 20);
  check_closed_solid(make_cone(Vec3(0.1, -1, 0), 0.2, Vec3(0.3, 1, 0.4), 1.1, false)->placed(uneven_placement()), 21);
  check_placement(make_cone(kBase, 2.0, kCap, 0.5, true), uneven_placement(), 22);
}

TEST(Cone, OfEqualRadiiIsACylinder) {
  expect_depths(make_cone(kBase, 1.0, kCap, 1.0, false), {Vec3(-5, 2, 0), Vec3(1, 0, 0)}, {4.0, 6.0});
}

}  // namespace
}  // namespace firstlight::render
