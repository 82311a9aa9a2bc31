#include "render/camera/projection.h"

#include <gtest/gtest.h>

#include <cmath>

namespace firstlight::render {
namespace {

Ray primary_ray(const Camera& camera, double x, double y, int width, int height) {
  return ray_through({camera, width, height}, x, y).value();
}

void expect_camera_vector(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).length(), 1e-12) << a << " is not " << b; }

TEST(Camera, MiddleOfThePictureLooksAlongTheDirection) {
  const Camera camera;
  const Ray ray = primary_ray(camera, 50.0, 25.0, 100, 50);
  EXPECT_EQ(ray.origin, camera.location);
  expect_camera_vector(ray.direction, {0.0, 0.0, 1.0});
}

TEST(Camera, FirstPictureCoordinateIsTheUpperLeftCorner) {
  const Camera camera;
  const double length = std::sqrt(0.665 * 0.665 + 0.25 + 1.0);
  expect_camera_vector(primary_ray(camera, 0.0, 0.0, 100, 50).direction, Vec3(-0.665, 0.5, 1.0) / length);
  expect_camera_vector(primary_ray(camera, 100.0, 50.0, 100, 50).direction, Vec3(0.665, -0.5, 1.0) / length);
}

TEST(Camera, LookAtTurnsAllAxesAndKeepsTheirLengths) {
  Camera camera;
  camera.location = {1.0, 2.0, 3.0};
  camera.direction = {0.0, 0.0, 2.0};
  look_at(camera, {11.0, 2.0, 3.0});
  expect_camera_vector(camera.direction, {2.0, 0.0, 0.0});
  expect_camera_vector(camera.right, {0.0, 0.0, -1.33});
  expect_camera_vector(camera.up, {0.0, 1.0, 0.0});
}

TEST(Camera, LookAtKeepsARightHandedCameraRightHanded) {
  Camera camera;
  camera.right = {-1.33, 0.0, 0.0};
  look_at(camera, {0.0, 0.0, 5.0});
  expect_camera_vector(camera.right, {-1.33, 0.0, 0.0});
  expect_camera_vector(camera.up, {0.0, 1.0, 0.0});
}

TEST(Camera, LookAtTurnsTheSkyUpwards) {
  Camera camera;
  camera.sky = {1.0, 0.0, 0.0};
  look_at(camera, {0.0, 0.0, 1.0});
  expect_camera_vector(camera.up, {1.0, 0.0, 0.0});
  expect_camera_vector(camera.right, {0.0, -1.33, 0.0});
}

TEST(Camera, LookAtAlongTheSkyKeepsTheRightVector) {
  Camera camera;
  look_at(camera, {0.0, 7.0, 0.0});
  expect_camera_vector(camera.direction, {0.0, 1.0, 0.0});
  expect_camera_vector(camera.right, {1.33, 0.0, 0.0});
  expect_camera_vector(camera.up, {0.0, 0.0, -1.0});
}

TEST(Camera, LookAtItsOwnPlaceGivesNoNotANumber) {
  Camera camera;
  look_at(camera, camera.location);
  const Vec3 direction = primary_ray(camera, 1.0, 2.0, 4, 4).direction;
  EXPECT_TRUE(std::isfinite(direction.x) && std::isfinite(direction.y) && std::isfinite(direction.z));
}

TEST(Camera, AngleIsThatBetweenTheLeftAndRightEdge) {
  Camera camera;
  set_angle(camera, 90.0);
  EXPECT_NEAR(camera.direction.length(), 0.665, 1e-12);
  const Vec3 left = primary_ray(camera, 0.0, 1.0, 2, 2).direction;
  const Vec3 right = primary_ray(camera, 2.0, 1.0, 2, 2).direction;
  EXPECT_NEAR(left.dot(right), 0.0, 1e-12);
}

TEST(Camera, IsPlacedWithItsAxes) {
  Camera camera;
  camera.location = {1.0, 0.0, 0.0};
  place(camera, Transform::scaling({2.0, 2.0, 2.0}).then(Transform::translation({0.0, 5.0, 0.0})));
  EXPECT_EQ(camera.location, Vec3(2.0, 5.0, 0.0));
  EXPECT_EQ(camera.direction, Vec3(0.0, 0.0, 2.0));
  EXPECT_EQ(camera.up, Vec3(0.0, 2.0, 0.0));
  EXPECT_EQ(camera.right, Vec3(2.66, 0.0, 0.0));
}

}  // namespace
}  // namespace firstlight::render
