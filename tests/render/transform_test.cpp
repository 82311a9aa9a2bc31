#include "render/math/transform.h"

#include "render/math/bounds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace firstlight::render {
namespace {

void expect_near(const Vec3& a, const Vec3& b, double tolerance = 1e-12) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Transform, RotationsAreLeftHanded) {
  expect_near(Transform::rotation(Vec3(90, 0, 0)).point(Vec3(0, 1, 0)), Vec3(0, 0, 1));
  expect_near(Transform::rotation(Vec3(0, 90, 0)).point(Vec3(0, 0, 1)), Vec3(1, 0, 0));
  expect_near(Transform::rotation(Vec3(0, 0, 90)).point(Vec3(1, 0, 0)), Vec3(0, 1, 0));
}

TEST(Transform, RotatesAboutXThenYThenZ) {
  // x turns y to z, y turns that z to x, z turns that x to y.
  expect_near(Transform::rotation(Vec3(90, 90, 90)).point(Vec3(0, 1, 0)), Vec3(0, 1, 0));
  const Vec3 p(1, 2, 3);
  const Transform steps = Transform::rotation(Vec3(10, 0, 0))
                              .then(Transform::rotation(Vec3(0, 20, 0)))
                              .then(Transform::rotation(Vec3(0, 0, 30)));
  expect_near(Transform::rotation(Vec3(10, 20, 30)).point(p), steps.point(p));
}

TEST(Transform, RotationAboutAnAxisAgreesWithTheCoordinateAxes) {
  const Vec3 p(1, 2, 3);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 unit(0.0);
    unit[axis] = 1.0;
    expect_near(Transform::rotation_about(unit * 5.0, 37.0).point(p), Transform::rotation(unit * 37.0).point(p));
  }
  expect_near(Transform::rotation_about(Vec3(1, 1, 1), 120.0).point(Vec3(1, 0, 0)), Vec3(0, 1, 0));
}

TEST(Transform, ThenAppliesInReadingOrder) {
  const Transform t = Transform::scaling(Vec3(2, 3, 4)).then(Transform::translation(Vec3(1, 1, 1)));
  expect_near(t.point(Vec3(1, 1, 1)), Vec3(3, 4, 5));
  expect_near(t.direction(Vec3(1, 1, 1)), Vec3(2, 3, 4));
  expect_near(t.inverse_point(Vec3(3, 4, 5)), Vec3(1, 1, 1));
}

TEST(Transform, InverseUndoesAGeneralMatrix) {
  const Mat4 m(1, 2, 0, 0, 0, 1, 3, 0, 4, 0, 1, 0, 5, 6, 7, 1);
  ASSERT_TRUE(Transform::is_invertible(m));
  const Transform t(m);
  const Vec3 p(0.3, -2.0, 9.0);
  expect_near(t.inverse_point(t.point(p)), p);
  expect_near(t.inverse().point(t.point(p)), p);
  EXPECT_TRUE(t.inverse().inverse().matrix() == m);
}

TEST(Transform, SingularAndNonFiniteMatricesAreRefused) {
  EXPECT_FALSE(Transform::is_invertible(Mat4(1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)));
  Mat4 broken;
  broken[3][0] = std::nan("");
  EXPECT_FALSE(Transform::is_invertible(broken));
  EXPECT_TRUE(Transform::is_invertible(Mat4()));
}

TEST(Transform, NormalsStayPerpendicularUnderUnevenScaling) {
  const Transform t = Transform::rotation(Vec3(10, 20, 30)).then(Transform::scaling(Vec3(1, 5, 0.2)));
  const Vec3 n(1, 2, 3);
  const Vec3 along = n.cross(Vec3(1, 0, 0));
  EXPECT_NEAR(t.normal(n).dot(t.direction(along)), 0.0, 1e-12);
}

TEST(Transform, InverseRayKeepsDepths) {
  const Transform t = Transform::scaling(Vec3(2, 5, 3)).then(Transform::rotation(Vec3(1, 2, 3)));
  const Ray ray{Vec3(1, 2, 3), Vec3(0.6, 0.0, 0.8)};
  expect_near(t.point(t.inverse_ray(ray).at(7.5)), ray.at(7.5));
}

TEST(Transform, BoxHoldsTheTurnedCornersAndKeepsOpenSides) {
  const Box3 turned = Transform::rotation(Vec3(0, 0, 45)).box(Box3(Vec3(-1), Vec3(1)));
  expect_near(turned.max, Vec3(std::sqrt(2.0), std::sqrt(2.0), 1.0));
  Box3 open = boundless_box();
  open.max.y = 2.0;
  const Box3 flipped = Transform::scaling(Vec3(1, -3, 1)).box(open);
  EXPECT_EQ(flipped.min.y, -6.0);
  EXPECT_EQ(flipped.max.y, kBoundless);
  EXPECT_EQ(flipped.min.x, -kBoundless);
}

TEST(Transform, IdentityIsKnown) {
  EXPECT_TRUE(Transform().is_identity());
  EXPECT_TRUE(Transform::translation(Vec3(0.0)).is_identity());
  EXPECT_TRUE(Transform::rotation(Vec3(0.0)).is_identity());
  EXPECT_FALSE(Transform::scaling(Vec3(1, 1, -1)).is_identity());
}

}  // namespace
}  // namespace firstlight::render
