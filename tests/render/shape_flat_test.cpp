#include "tests/render/shape_test_support.h"

#include "render/shape/box.h"

namespace firstlight::render {
namespace {

TEST(Plane, KeepsItsDistanceAlongTheNormal) {
  const ShapePtr plane = make_plane(Vec3(0, 4, 0), 3.0);
  expect_depths(plane, {Vec3(5, 10, 5), Vec3(0, -1, 0)}, {7.0});
  expect_normal(plane, {Vec3(5, 10, 5), Vec3(0, -1, 0)}, 0, Vec3(0, 1, 0));
  EXPECT_TRUE(plane->inside(Vec3(0, 2.9, 0)));
  EXPECT_FALSE(plane->inside(Vec3(0, 3.1, 0)));
  EXPECT_TRUE(plane->inverted()->inside(Vec3(0, 3.1, 0)));
  expect_depths(plane, {Vec3(5, 10, 5), Vec3(1, 0, 0)}, {});
}

TEST(Plane, MovesWithAnyTransformation) {
  const ShapePtr plane = make_plane(Vec3(1, 2, 3), 0.4);
  check_placement(plane, uneven_placement(), 1);
  expect_near(make_plane(Vec3(0, 1, 0), 1)->placed(Transform::scaling(Vec3(1, -2, 1)))->normal(Vec3(0.0), {}),
              Vec3(0, -1, 0));
}

TEST(Plane, AlongAnAxisBoundsWhatLiesBehindIt) {
  const ShapePtr plane = make_plane(Vec3(0, -1, 0), 2.0);
  EXPECT_EQ(plane->inside_bounds().min.y, -2.0);
  EXPECT_EQ(plane->inside_bounds().max.y, kBoundless);
  EXPECT_FALSE(is_bounded(plane->bounds()));
}

TEST(Box, RepairsExchangedCorners) {
  const ShapePtr box = make_box(Vec3(1, 1, 1), Vec3(-1, -1, -1));
  expect_depths(box, {Vec3(-5, 0, 0), Vec3(1, 0, 0)}, {4.0, 6.0});
  EXPECT_TRUE(box->inside(Vec3(0.0)));
}

TEST(Box, HasTheNormalOfTheSideThatIsMet) {
  const ShapePtr box = make_box(Vec3(-1, -2, -3), Vec3(1, 2, 3));
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 d(0.0);
    d[axis] = 1.0;
    const double half = 1.0 + axis;
    expect_depths(box, {d * -10.0, d}, {10.0 - half, 10.0 + half});
    expect_normal(box, {d * -10.0, d}, 0, -d);
    expect_normal(box, {d * -10.0, d}, 1, d);
    expect_normal(box, {d * 10.0, -d}, 0, d);
  }
}

TEST(Box, IsAClosedSolid) {
  check_closed_solid(make_box(Vec3(-1, -0.5, -2), Vec3(0.5, 1, 1)), 2);
  check_closed_solid(make_box(Vec3(-1, -0.5, -2), Vec3(0.5, 1, 1))->placed(uneven_placement()), 3);
  check_placement(make_box(Vec3(-1, -0.5, -2), Vec3(0.5, 1, 1)), uneven_placement(), 4);
}

TEST(Box, StaysAlongTheAxesWhenScaledAndMoved) {
  const Transform t = Transform::scaling(Vec3(2, -1, 1)).then(Transform::translation(Vec3(1, 0, 0)));
  const ShapePtr moved = make_box(Vec3(0.0), Vec3(1.0))->placed(t);
  ASSERT_NE(dynamic_cast<const Box*>(moved.get()), nullptr);
  expect_near(moved->bounds().min, Vec3(1, -1, 0));
  expect_near(moved->bounds().max, Vec3(3, 0, 1));
  check_placement(make_box(Vec3(0.0), Vec3(1.0)), t, 5);
}

TEST(Disc, HasARoundHole) {
  const ShapePtr disc = make_disc(Vec3(0, 1, 0), Vec3(0, 5, 0), 2.0, 1.0);
  expect_depths(disc, {Vec3(1.5, 5, 0), Vec3(0, -1, 0)}, {4.0});
  expect_depths(disc, {Vec3(0, 5, 0.5), Vec3(0, -1, 0)}, {});
  expect_depths(disc, {Vec3(0, 5, 2.1), Vec3(0, -1, 0)}, {});
  expect_normal(disc, {Vec3(1.5, 5, 0), Vec3(0, -1, 0)}, 0, Vec3(0, 1, 0));
  EXPECT_TRUE(disc->inside(Vec3(9, 0, 9)));
  EXPECT_FALSE(disc->inside(Vec3(9, 2, 9)));
}

TEST(Disc, IsPlacedWithItsNormal) {
  check_placement(make_disc(Vec3(0.1, 0.2, 0.3), Vec3(1, -2, 0.5), 1.5, 0.2), uneven_placement(), 6);
}

TEST(Triangle, IsMetWithinItsOutlineFromBothSides) {
  const ShapePtr triangle = make_triangle(Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0));
  expect_depths(triangle, {Vec3(0.5, 0.5, -3), Vec3(0, 0, 1)}, {3.0});
  expect_depths(triangle, {Vec3(0.5, 0.5, 3), Vec3(0, 0, -1)}, {3.0});
  expect_depths(triangle, {Vec3(1.5, 1.5, -3), Vec3(0, 0, 1)}, {});
  expect_depths(triangle, {Vec3(1, 1, -3), Vec3(0, 0, 1)}, {3.0});
  EXPECT_FALSE(triangle->inside(Vec3(0.5, 0.5, 0)));
  EXPECT_FALSE(triangle->inverted()->inside(Vec3(0.5, 0.5, 0)));
}

TEST(Triangle, CoversTheSamePointsInEveryProjectionAndOrder) {
  RayRain rain(7);
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = rain.point(2.0);
    const Vec3 b = rain.point(2.0);
    const Vec3 c = rain.point(2.0);
    const ShapePtr one = make_triangle(a, b, c);
    const ShapePtr other = make_triangle(c, b, a);
    for (int k = 0; k < 20; ++k) {
      const Ray ray = rain.next();
      const std::vector<double> found = depths(one, ray);
      ASSERT_EQ(found.size(), depths(other, ray).size());
      // Barycentric coordinates from the volumes that the ray makes with the edges.
      const double u = (b - ray.origin).cross(c - ray.origin).dot(ray.direction);
      const double v = (c - ray.origin).cross(a - ray.origin).dot(ray.direction);
      const double w = (a - ray.origin).cross(b - ray.origin).dot(ray.direction);
      const bool through = (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
      const double ahead = (a - ray.origin).dot((b - a).cross(c - a)) / ray.direction.dot((b - a).cross(c - a));
      ASSERT_EQ(found.size(), through && ahead > 1e-6 ? 1u : 0u);
    }
  }
}

TEST(Triangle, WithoutAreaIsRefused) {
  EXPECT_EQ(make_triangle(Vec3(0.0), Vec3(1.0), Vec3(2.0)), nullptr);
  EXPECT_EQ(make_triangle(Vec3(0.0), Vec3(0.0), Vec3(1, 0, 0)), nullptr);
}

TEST(SmoothTriangle, InterpolatesTheNormalsOfItsCorners) {
  const Vec3 na = Vec3(-0.3, -0.2, -1).normalized();
  const Vec3 nb = Vec3(0.4, 0, -1).normalized();
  const Vec3 nc = Vec3(0, 0.5, -1).normalized();
  const Vec3 a(0, 0, 0);
  const Vec3 b(2, 0, 0);
  const Vec3 c(0, 2, 0);
  const ShapePtr triangle = make_smooth_triangle(a, na * 3.0, b, nb, c, nc);
  ASSERT_NE(triangle, nullptr);
  for (const Vec3& weights : {Vec3(0.2, 0.5, 0.3), Vec3(0.9, 0.05, 0.05), Vec3(0.1, 0.1, 0.8)}) {
    const Vec3 p = a * weights.x + b * weights.y + c * weights.z;
    expect_normal(triangle, {p - Vec3(0, 0, 3), Vec3(0, 0, 1)}, 0,
                  (na * weights.x + nb * weights.y + nc * weights.z).normalized());
  }
  const Transform quarter = Transform::rotation(Vec3(0, 0, 90));
  const Vec3 p = quarter.point(b * 0.5 + c * 0.5);
  expect_normal(triangle->placed(quarter), {p - Vec3(0, 0, 3), Vec3(0, 0, 1)}, 0,
                quarter.direction((nb + nc).normalized()));
}

TEST(SmoothTriangle, WithNormalsOnBothSidesIsRefused) {
  const Vec3 up(0, 0, 1);
  EXPECT_EQ(make_smooth_triangle(Vec3(0.0), up, Vec3(1, 0, 0), -up, Vec3(0, 1, 0), up), nullptr);
  EXPECT_EQ(make_smooth_triangle(Vec3(0.0), up, Vec3(1, 0, 0), Vec3(0.0), Vec3(0, 1, 0), up), nullptr);
}

}  // namespace
}  // namespace firstlight::render
