#include "render/camera/lens.h"
#include "render/camera/lens_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace firstlight::render {
namespace {

TEST(LensGrid, HasAsManyPointsAsAreAskedForWithinTheLens) {
  for (const int samples : {1, 2, 4, 5, 7, 8, 19, 20, 37, 38, 100, 1000}) {
    const LensGrid grid = round_lens(samples);
    ASSERT_EQ(grid.points.size(), static_cast<std::size_t>(samples));
    std::set<std::pair<double, double>> places;
    for (const LensPoint& point : grid.points) {
      EXPECT_LE(std::hypot(point.x, point.y), 0.5);
      EXPECT_TRUE(places.emplace(point.x, point.y).second);
    }
  }
}

TEST(LensGrid, BalancesARoundLens) {
  for (const int samples : {4, 7, 19, 37, 300}) {
    double x = 0.0;
    double y = 0.0;
    for (const LensPoint& point : round_lens(samples).points) {
      x += point.x / samples;
      y += point.y / samples;
    }
    EXPECT_NEAR(x, 0.0, 0.01) << samples;
    EXPECT_NEAR(y, 0.0, 0.01) << samples;
  }
}

TEST(LensGrid, TakesPointsWhereAShapedLensIsBright) {
  const LensGrid grid = shaped_lens(200, [](double x, double) { return x > 0.75 ? 1.0 : 0.0; });
  const auto bright = std::ranges::count_if(grid.points, [](const LensPoint& point) { return point.x > 0.25; });
  EXPECT_GT(bright, 190);  // some are taken for lack of patience
}

TEST(LensGrid, ABlackLensHasPointsToo) {
  EXPECT_EQ(shaped_lens(50, [](double, double) { return 0.0; }).points.size(), 50u);
}

/// Looks along z from 2 * z, with a lens of 0.4, sharp at 5 * z.
Camera blurred() {
  Camera camera;
  camera.location = Vec3(0.0, 0.0, 2.0);
  camera.blur.aperture = 0.4;
  camera.blur.samples = 19;
  camera.blur.focal_distance = 3.0;
  return camera;
}

TEST(Lens, RaysOfAPlaceMeetAtTheFocalDistance) {
  const Camera camera = blurred();
  const Lens lens(camera, round_lens(camera.blur.samples));
  const Box3 origins = ray_origins(camera);
  for (std::uint32_t number = 0; number < 19; ++number) {
    CameraRays rays;
    rays.direction.set(3, Vec3(0.25, -0.5, 1.0));
    lens.bend({10.5, 20.5, number}, 3, rays);
    const Vec3 origin = rays.origin.vector(3);
    EXPECT_EQ(origin.z, 2.0);
    EXPECT_LE(std::hypot(origin.x, origin.y), 0.4 * (0.5 + 0.15));
    EXPECT_TRUE(origins.intersects(origin));
    const Vec3 direction = rays.direction.vector(3);
    const Vec3 at_focus = origin + direction * ((5.0 - origin.z) / direction.z);
    EXPECT_NEAR(at_focus.x, 0.75, 1e-12);
    EXPECT_NEAR(at_focus.y, -1.5, 1e-12);
  }
}

TEST(Lens, PlacesStayNearTheirPixelAndDependOnTheNumber) {
  const Camera camera = blurred();
  const Lens lens(camera, round_lens(camera.blur.samples));
  std::set<std::pair<double, double>> places;
  for (std::uint32_t number = 0; number < 19; ++number) {
    const LensSample moved = lens.moved({7.5, 3.5, number});
    EXPECT_EQ(moved.number, number);
    EXPECT_NEAR(moved.x, 7.5, 0.6);
    EXPECT_NEAR(moved.y, 3.5, 0.6);
    places.emplace(moved.x, moved.y);
  }
  EXPECT_GT(places.size(), 12u);
}

TEST(Lens, WithoutALensRaysBeginWhereTheCameraIs) {
  Camera camera = blurred();
  camera.blur.samples = 0;
  EXPECT_EQ(ray_origins(camera).min, camera.location);
  EXPECT_EQ(ray_origins(camera).max, camera.location);
}

}  // namespace
}  // namespace firstlight::render
