#include "tests/parser/object_text.h"

namespace firstlight::parser {
namespace {

using render::Camera;
using render::CameraKind;
using render::Vec3;

Camera camera_of(const std::string& words) {
  return described_scene("sphere { 0, 1 } camera { " + words + " }")->camera;
}
std::string mistake(const std::string& words) { return errors(described("sphere { 0, 1 } camera { " + words + " }")); }

TEST(ParseCameraKind, EachKindIsKnown) {
  struct Case {
    const char* words;
    CameraKind kind;
  };
  const Case cases[] = {
      {"perspective", CameraKind::perspective}, {"orthographic", CameraKind::orthographic},
      {"fisheye", CameraKind::fisheye},         {"ultra_wide_angle", CameraKind::ultra_wide_angle},
      {"omnimax", CameraKind::omnimax},         {"panoramic", CameraKind::panoramic},
      {"cylinder 1", CameraKind::cylinder_1},   {"cylinder 2", CameraKind::cylinder_2},
      {"cylinder 3", CameraKind::cylinder_3},   {"cylinder 4", CameraKind::cylinder_4},
      {"spherical", CameraKind::spherical},
  };
  for (const Case& one : cases) {
    const Camera camera = camera_of(std::string(one.words) + " location -5*z look_at 0");
    EXPECT_EQ(camera.kind, one.kind) << one.words;
    EXPECT_EQ(spelled(camera.unrendered), "") << one.words;
  }
  EXPECT_NE(mistake("cylinder 5").find("1, 2, 3 or 4"), std::string::npos);
  EXPECT_NE(mistake("location -z fisheye").find("first word"), std::string::npos);
}

TEST(ParseCameraKind, AnglesGoByTheKind) {
  EXPECT_EQ(camera_of("fisheye angle 220").angle, 220.0);
  EXPECT_EQ(camera_of("panoramic").angle, 90.0);
  const Camera half = camera_of("spherical angle 180");
  EXPECT_EQ(half.horizontal_angle, 180.0);
  EXPECT_EQ(half.vertical_angle, 90.0);
  EXPECT_EQ(camera_of("spherical angle 100, 50").vertical_angle, 50.0);
  EXPECT_EQ(camera_of("spherical").horizontal_angle, 360.0);
  EXPECT_NE(mistake("orthographic angle 180").find("below 180"), std::string::npos);
  EXPECT_NE(mistake("spherical angle -1").find("negative"), std::string::npos);
}

TEST(ParseCameraKind, OrthographicPictureIsAsLargeAsTheViewAtLookAt) {
  const Camera plain = camera_of("orthographic location -5*z look_at 0");
  expect_near(plain.right, Vec3(1.33 * 5, 0, 0));
  expect_near(plain.up, Vec3(0, 5, 0));
  const Camera given = camera_of("orthographic location -5*z look_at 0 right 4*x up 3*y");
  expect_near(given.right, Vec3(4, 0, 0));
  expect_near(given.up, Vec3(0, 3, 0));
  const Camera angled = camera_of("orthographic location -5*z look_at 0 right 4*x up 3*y angle 90");
  expect_near(angled.right, Vec3(10, 0, 0));
  expect_near(angled.up, Vec3(0, 7.5, 0));
}

TEST(ParseCameraKind, MeshCameraTakesMeshes) {
  const Camera camera = camera_of(
      "mesh_camera { 1 3 0.5 mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> } } smooth } location "
      "z");
  EXPECT_EQ(camera.kind, CameraKind::mesh);
  EXPECT_EQ(spelled(camera.unrendered), "");
  EXPECT_EQ(camera.mesh.rays_per_pixel, 1);
  EXPECT_EQ(camera.mesh.distribution, 3);
  EXPECT_EQ(camera.mesh.max_ray_distance, 0.5);
  EXPECT_TRUE(camera.mesh.smooth);
  EXPECT_EQ(camera.mesh.meshes.size(), 1u);
  for (const char* words :
       {"0 0 mesh { triangle { 0, x, y } }", "1 4 mesh { triangle { 0, x, y } }", "2 2 mesh { triangle { 0, x, y } }",
        "2 0 mesh { triangle { 0, x, y } }", "1 0 mesh { triangle { 0, x, y } } smooth", "1 0"}) {
    EXPECT_NE(mistake("mesh_camera { " + std::string(words) + " }"), "") << words;
  }
}

TEST(ParseCamera, NormalTurnsItsRays) {
  const Camera camera = camera_of("location -5*z look_at 0 normal { bumps 0.3 scale 0.1 }");
  ASSERT_TRUE(camera.normal);
  EXPECT_EQ(camera.normal->amount, 0.3);
  EXPECT_EQ(spelled(camera.unrendered), "");
  EXPECT_FALSE(camera_of("location -5*z").normal);
  const auto old = described("#version 3.1; sphere { 0, 1 } camera { location -z normal { bumps } }");
  EXPECT_TRUE(old.scene && old.scene->camera.normal);
}

TEST(ParseCameraBlur, ItsWordsAreRead) {
  const Camera camera = camera_of(
      "location -5*z look_at 0 aperture 0.4 blur_samples 10, 50 focal_point 2*z confidence 0.95 variance 1/200 "
      "bokeh { pigment { color rgb 1 } }");
  EXPECT_EQ(camera.blur.aperture, 0.4);
  EXPECT_EQ(camera.blur.min_samples, 10);
  EXPECT_EQ(camera.blur.samples, 50);
  EXPECT_EQ(camera.blur.focal_distance, 7.0);
  EXPECT_EQ(camera.blur.confidence, 0.95);
  EXPECT_EQ(camera.blur.variance, 0.005);
  EXPECT_TRUE(camera.blur.bokeh);
  EXPECT_TRUE(camera.blur.shows());
}

TEST(ParseCameraBlur, DefaultsArePovRays) {
  const Camera camera = camera_of("location -5*z look_at 0 direction 2*z");
  EXPECT_EQ(camera.blur.aperture, 0.0);
  EXPECT_EQ(camera.blur.samples, 0);
  EXPECT_EQ(camera.blur.confidence, 0.9);
  EXPECT_EQ(camera.blur.variance, 0.0001);
  EXPECT_EQ(camera.blur.focal_distance, 2.0);
  EXPECT_FALSE(camera.blur.bokeh);
}

TEST(ParseCameraBlur, ShowsWithApertureAndSamplesOnly) {
  EXPECT_FALSE(camera_of("aperture 0.4 focal_point x").blur.shows());
  EXPECT_FALSE(camera_of("blur_samples 10").blur.shows());
  EXPECT_TRUE(camera_of("aperture 0.4 blur_samples 10").blur.shows());
}

TEST(ParseCameraBlur, RefusesWhatMakesNoSense) {
  EXPECT_NE(mistake("blur_samples 0").find("above 0"), std::string::npos);
  EXPECT_NE(mistake("blur_samples 10, 5").find("smaller one"), std::string::npos);
  EXPECT_NE(mistake("blur_samples 10, 70000").find("at most 65536"), std::string::npos);
  const auto result = described("sphere { 0, 1 } camera { confidence 2 variance -1 }");
  EXPECT_EQ(result.scene->camera.blur.confidence, 0.9);
  EXPECT_NE(warnings(result).find("'confidence' must be"), std::string::npos);
  EXPECT_NE(warnings(result).find("'variance' must be"), std::string::npos);
}

TEST(ParseCamera, DefaultCameraIsWhereOthersBegin) {
  const Camera camera =
      described_scene("sphere { 0, 1 } #default { camera { fisheye angle 200 location 3*z } } camera { up 2*y }")
          ->camera;
  EXPECT_EQ(camera.kind, CameraKind::fisheye);
  EXPECT_EQ(camera.location, Vec3(0, 0, 3));
}

TEST(ParseCamera, DeclaredCameraKeepsItsKind) {
  const auto scene = described_scene(
      "sphere { 0, 1 } #declare C = camera { panoramic aperture 1 blur_samples 4 } camera { C translate x }");
  EXPECT_EQ(scene->camera.kind, CameraKind::panoramic);
  EXPECT_TRUE(scene->camera.blur.shows());
}

}  // namespace
}  // namespace firstlight::parser
