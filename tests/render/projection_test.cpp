#include "render/camera/projection.h"

#include "render/scene/scene_builder.h"
#include "render/trace/medium_table.h"
#include "render/trace/primary.h"
#include "render/trace/start_medium.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string_view>

namespace firstlight::render {
namespace {

const double kDiagonal = std::sqrt(0.5);

void expect_vector(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).length(), 1e-12) << a << " is not " << b; }

/// At (1, 2, 3), looking along z, the picture twice as wide as high.
Camera camera_of(CameraKind kind, double angle = 90.0) {
  Camera camera;
  camera.kind = kind;
  camera.location = {1.0, 2.0, 3.0};
  camera.direction = {0.0, 0.0, 3.0};
  camera.right = {2.0, 0.0, 0.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.angle = angle;
  return camera;
}

/// The ray through a place: (0, 0) is the lower left corner of the picture, (1, 1) the upper right one.
std::optional<Ray> ray_at(const Camera& camera, double x, double y) { return ray_through({camera, 1, 1}, x, 1.0 - y); }

TEST(Projection, MiddleOfThePictureLooksAlongTheDirection) {
  for (const CameraKind kind :
       {CameraKind::perspective, CameraKind::orthographic, CameraKind::fisheye, CameraKind::ultra_wide_angle,
        CameraKind::panoramic, CameraKind::cylinder_1, CameraKind::cylinder_2, CameraKind::cylinder_3,
        CameraKind::cylinder_4, CameraKind::spherical}) {
    const auto ray = ray_at(camera_of(kind), 0.5, 0.5);
    ASSERT_TRUE(ray);
    expect_vector(ray->origin, {1.0, 2.0, 3.0});
    expect_vector(ray->direction, {0.0, 0.0, 1.0});
  }
}

TEST(Projection, OrthographicRaysAreParallelAndBeginInThePicture) {
  const auto ray = ray_at(camera_of(CameraKind::orthographic), 0.0, 1.0);
  ASSERT_TRUE(ray);
  expect_vector(ray->origin, {0.0, 2.5, 3.0});
  expect_vector(ray->direction, {0.0, 0.0, 1.0});
}

TEST(Projection, FisheyeHasItsAngleAtTheRimAndNothingBeyond) {
  Camera camera = camera_of(CameraKind::fisheye, 180.0);
  camera.right = {1.0, 0.0, 0.0};
  expect_vector(ray_at(camera, 1.0, 0.5).value().direction, {1.0, 0.0, 0.0});
  expect_vector(ray_at(camera, 0.5, 1.0).value().direction, {0.0, 1.0, 0.0});
  expect_vector(ray_at(camera, 0.25, 0.5).value().direction, {-kDiagonal, 0.0, kDiagonal});
  EXPECT_FALSE(ray_at(camera, 0.0, 0.0));
  EXPECT_FALSE(ray_at(camera, 1.0, 1.0));
  // Twice as wide as the disc: a quarter of the way from the middle is its rim.
  expect_vector(ray_at(camera_of(CameraKind::fisheye, 180.0), 0.75, 0.5).value().direction, {1.0, 0.0, 0.0});
  EXPECT_FALSE(ray_at(camera_of(CameraKind::fisheye, 180.0), 0.76, 0.5));
}

TEST(Projection, UltraWideAngleHasItsAngleFromSideToSide) {
  const Camera camera = camera_of(CameraKind::ultra_wide_angle, 180.0);
  expect_vector(ray_at(camera, 1.0, 0.5).value().direction, {1.0, 0.0, 0.0});
  expect_vector(ray_at(camera, 0.5, 0.0).value().direction, {0.0, -kDiagonal, kDiagonal});  // half as high as wide
}

TEST(Projection, OmnimaxHasNothingBesideItsDiscNorFarBelowTheDirection) {
  Camera camera = camera_of(CameraKind::omnimax);
  camera.right = {1.0, 0.0, 0.0};
  EXPECT_FALSE(ray_at(camera, 0.0, 0.0));
  EXPECT_FALSE(ray_at(camera, 1.0, 1.0));
  const double rim = 1.411269 - 0.09439 + 0.25674;  // 90.1 degrees
  expect_vector(ray_at(camera, 0.5, 1.0).value().direction, {0.0, std::sin(rim), std::cos(rim)});
  EXPECT_TRUE(ray_at(camera, 0.5, 0.25));   // 41 degrees below
  EXPECT_FALSE(ray_at(camera, 0.5, 0.15));  // 59 degrees below
  // The direction of a wide one lies where 1.283458 times as much is above it as a square one has.
  EXPECT_TRUE(ray_at(camera_of(CameraKind::omnimax), 0.5, 0.5 - 0.5 * (1.283458 - 1.0) + 1e-9));
  expect_vector(ray_at(camera_of(CameraKind::omnimax), 0.5, 1.0).value().direction,
                {0.0, std::sin(rim), std::cos(rim)});
}

TEST(Projection, PanoramicIsHalfATurnWideAndStraightUpAtTheTop) {
  Camera camera = camera_of(CameraKind::panoramic);
  camera.right = {1.0, 0.0, 0.0};
  camera.direction = {0.0, 0.0, 1.0};
  expect_vector(ray_at(camera, 0.0, 0.5).value().direction, {-1.0, 0.0, 0.0});
  expect_vector(ray_at(camera, 1.0, 0.5).value().direction, {1.0, 0.0, 0.0});
  expect_vector(ray_at(camera, 0.5, 0.75).value().direction, {0.0, kDiagonal, kDiagonal});
  EXPECT_NEAR(ray_at(camera, 0.5, 1.0).value().direction.y, 1.0, 1e-12);
  EXPECT_NEAR(ray_at(camera, 0.5, 0.0).value().direction.y, -1.0, 1e-12);
}

TEST(Projection, CylindersGoRoundTheirAxis) {
  expect_vector(ray_at(camera_of(CameraKind::cylinder_1, 180.0), 1.0, 0.5).value().direction, {1.0, 0.0, 0.0});
  expect_vector(ray_at(camera_of(CameraKind::cylinder_1, 180.0), 0.5, 1.0).value().direction,
                Vec3(0.0, 0.5, 1.0).normalized());
  expect_vector(ray_at(camera_of(CameraKind::cylinder_2, 180.0), 0.5, 1.0).value().direction, {0.0, 1.0, 0.0});
  expect_vector(ray_at(camera_of(CameraKind::cylinder_2, 180.0), 0.0, 0.5).value().direction,
                {-kDiagonal, 0.0, kDiagonal});
  const auto upright = ray_at(camera_of(CameraKind::cylinder_3, 180.0), 0.0, 1.0).value();
  expect_vector(upright.origin, {1.0, 2.5, 3.0});
  expect_vector(upright.direction, {-1.0, 0.0, 0.0});
  const auto level = ray_at(camera_of(CameraKind::cylinder_4, 180.0), 1.0, 0.0).value();
  expect_vector(level.origin, {2.0, 2.0, 3.0});
  expect_vector(level.direction, {0.0, -1.0, 0.0});
}

TEST(Projection, SphericalHasLongitudesAcrossAndLatitudesUpwards) {
  const Camera camera = camera_of(CameraKind::spherical);
  expect_vector(ray_at(camera, 0.0, 0.5).value().direction, {0.0, 0.0, -1.0});
  expect_vector(ray_at(camera, 0.75, 0.5).value().direction, {1.0, 0.0, 0.0});
  expect_vector(ray_at(camera, 0.5, 1.0).value().direction, {0.0, 1.0, 0.0});
  expect_vector(ray_at(camera, 0.5, 0.25).value().direction, {0.0, -kDiagonal, kDiagonal});
}

TEST(Projection, AllRaysBeginWithinTheirOrigins) {
#define CAMERA(kind, word, maker) CameraKind::kind,
  for (const CameraKind kind : {
#include "render/camera/cameras.def"
       }) {
#undef CAMERA
    const Camera camera = camera_of(kind);
    const Box3 origins = make_projection(camera)->origins();
    for (const double x : {-1.0, 0.0, 0.3, 1.0, 2.0}) {
      for (const double y : {-1.0, 0.0, 0.3, 1.0, 2.0}) {
        const auto ray = ray_at(camera, x, y);
        if (!ray) continue;
        EXPECT_TRUE(origins.intersects(ray->origin));
        EXPECT_NEAR(ray->direction.length(), 1.0, 1e-12);
      }
    }
  }
}

TEST(Projection, EachKindHasAScene) {
  constexpr std::string_view kKinds[] = {
#define CAMERA(kind, word, maker) #kind,
#include "render/camera/cameras.def"
#undef CAMERA
  };
  const auto folder = std::filesystem::path(FIRSTLIGHT_SOURCE_DIR) / "testscenes" / "cameras";
  for (const std::string_view kind : kKinds) {
    const auto scene = folder / (std::string(kind) + ".pov");
    EXPECT_TRUE(std::filesystem::exists(scene)) << scene;
  }
}

TEST(PrimaryRays, SamplesThatNoRayLightsAreDark) {
  SceneBuilder builder;
  builder.set_camera(camera_of(CameraKind::fisheye));
  const auto scene = builder.build();
  MediumTable media;
  const PrimaryRays rays(*scene, media, {scene->camera, 40, 20});
  PrimaryBatch batch;
  const PrimaryPlace places[] = {{0.5, 0.5, 7}, {20.0, 10.0, 8}, {39.5, 19.5, 9}};
  rays.append(places, batch);
  ASSERT_EQ(batch.tasks.size(), 1u);
  EXPECT_EQ(batch.tasks[0].sample, 8u);
  ASSERT_EQ(batch.rays.size(), 1u);
  EXPECT_EQ(batch.dark, (std::vector<std::uint32_t>{7, 9}));
}

}  // namespace
}  // namespace firstlight::render
