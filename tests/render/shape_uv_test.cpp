#include "render/shape/blob.h"
#include "render/shape/mesh.h"
#include "tests/render/shape_test_support.h"
#include "tests/render/textures_at.h"

namespace firstlight::render {
namespace {

Vec2 uv_of(const ShapePtr& shape, const Ray& ray) {
  std::vector<Crossing> all = met(shape, ray);
  EXPECT_FALSE(all.empty());
  if (all.empty()) return Vec2(-1.0);
  const auto first =
      std::ranges::min_element(all, [](const Crossing& a, const Crossing& b) { return a.depth < b.depth; });
  return shape->uv(ray.at(first->depth), *first);
}

void expect_uv(const ShapePtr& shape, const Ray& ray, const Vec2& expected) {
  const Vec2 uv = uv_of(shape, ray);
  EXPECT_NEAR(uv.x, expected.x, 1e-9);
  EXPECT_NEAR(uv.y, expected.y, 1e-9);
}

const Ray kFromX{Vec3(10, 0, 0), Vec3(-1, 0, 0)};
const Ray kFromBelow{Vec3(0, -10, 0), Vec3(0, 1, 0)};
const Ray kFromZ{Vec3(0, 0, 10), Vec3(0, 0, -1)};

TEST(Uv, OfASphereIsLongitudeAndLatitude) {
  const ShapePtr sphere = make_sphere(Vec3(0.0), 2.0);
  expect_uv(sphere, kFromX, Vec2(0.0, 0.5));
  expect_uv(sphere, kFromZ, Vec2(0.25, 0.5));
  expect_uv(sphere, kFromBelow, Vec2(0.0, 0.0));
}

TEST(Uv, OfASphereTurnsWithIt) {
  const Transform quarter = Transform::rotation(Vec3(0, 90, 0));
  const ShapePtr sphere = make_sphere(Vec3(0.0), 2.0)->placed(quarter);
  EXPECT_NEAR(uv_of(sphere, kFromZ).x, uv_of(make_sphere(Vec3(0.0), 2.0), {quarter.inverse_point(Vec3(0, 0, 10)),
                                                                             quarter.inverse_direction(Vec3(0, 0, -1))})
                                           .x,
              1e-9);
  const ShapePtr twice = sphere->placed(Transform::scaling(Vec3(1, 2, 3)))->inverted();
  EXPECT_NEAR(uv_of(twice, kFromX).y, 0.5, 1e-9);
  EXPECT_NEAR(uv_of(twice, kFromX).x, uv_of(sphere, kFromX).x, 1e-9);
}

TEST(Uv, OfABoxIsACross) {
  const ShapePtr box = make_box(Vec3(-1), Vec3(1));
  expect_uv(box, kFromX, Vec2(0.625, 0.5));
  expect_uv(box, {Vec3(-10, 0, 0), Vec3(1, 0, 0)}, Vec2(0.125, 0.5));
  expect_uv(box, kFromBelow, Vec2(0.375, 1.0 / 6.0));
  expect_uv(box, kFromZ, Vec2(0.375, 0.5));
  expect_uv(box, {Vec3(0, 0, -10), Vec3(0, 0, 1)}, Vec2(0.875, 0.5));
  expect_uv(box->placed(Transform::rotation(Vec3(0, 0, 90))), {Vec3(0, 10, 0), Vec3(0, -1, 0)}, Vec2(0.625, 0.5));
}

TEST(Uv, OfATorusGoesAroundTwice) {
  const ShapePtr torus = make_torus(2.0, 0.5);
  expect_uv(torus, kFromX, Vec2(0.5, 0.5));
  expect_uv(torus, {Vec3(0, 10, 2), Vec3(0, -1, 0)}, Vec2(0.25, 0.75));
}

TEST(Uv, OfOtherShapesIsThePlaceInSpace) {
  const ShapePtr cylinder = make_cylinder(Vec3(0, -1, 0), Vec3(0, 1, 0), 1.0, false);
  expect_uv(cylinder->placed(Transform::translation(Vec3(3, 0, 0))), {Vec3(3.25, 0.5, -10), Vec3(0, 0, 1)},
            Vec2(3.25, 0.5));
}

/// Crossings of rays with a shape, side by side; `crossings` holds them.
std::unique_ptr<SurfacePlaces> places_on(const Shape& shape, std::vector<Crossing>& crossings) {
  auto places = std::make_unique<SurfacePlaces>();
  crossings.reserve(kRaysAtOnce);
  for (int i = 0; crossings.size() < kRaysAtOnce && i < 10'000; ++i) {
    const Ray ray{Vec3(5.0 * std::cos(i), 5.0 * std::sin(i), 5.0 * std::sin(3.0 * i)), Vec3(0.0)};
    const Vec3 target(0.4 * std::sin(5.0 * i), 0.4 * std::cos(7.0 * i), 0.3);
    std::vector<Crossing> all;
    shape.crossings({ray.origin, (target - ray.origin).normalized()}, all);
    if (all.empty()) continue;
    const std::size_t k = crossings.size();
    crossings.push_back(all.front());
    places->crossing[k] = &crossings.back();
    places->point.set(k, ray.origin + (target - ray.origin).normalized() * all.front().depth);
  }
  EXPECT_EQ(crossings.size(), kRaysAtOnce);
  return places;
}

/// A run that begins and ends within the places is asked as its points are, one by one.
void expect_runs_of_points(const ShapePtr& shape) {
  constexpr std::size_t kFirst = 3;
  constexpr std::size_t kEnd = 61;
  std::vector<Crossing> crossings;
  const std::unique_ptr<SurfacePlaces> places = places_on(*shape, crossings);
  if (crossings.size() < kRaysAtOnce) return;
  Columns3<double> normals;
  Columns2<double> uvs;
  std::vector<TextureShare> shares;
  shape->normals(*places, kFirst, kEnd, normals);
  shape->uvs(*places, kFirst, kEnd, uvs);
  shape->textures(*places, kFirst, kEnd, shares);
  auto share = shares.begin();
  for (std::size_t i = kFirst; i < kEnd; ++i) {
    const Vec3 point = places->point.vector(i);
    EXPECT_EQ(normals.vector(i), shape->normal(point, crossings[i]));
    EXPECT_EQ(uvs.vector(i), shape->uv(point, crossings[i]));
    for (const TextureShare& alone : textures_at(*shape, point, crossings[i])) {
      ASSERT_NE(share, shares.end());
      EXPECT_EQ(share->place, i);
      EXPECT_EQ(share->texture, alone.texture);
      EXPECT_EQ(share->weight, alone.weight);
      ++share;
    }
  }
  EXPECT_EQ(share, shares.end());
}

TEST(Runs, AreAskedAsTheirPoints) {
  const Transform placement =
      Transform::scaling(Vec3(1.0, 1.5, 0.75)).then(Transform::translation(Vec3(0.25, 0.0, 0.125)));
  BlobParameters blob;
  blob.threshold = 0.4;
  for (std::uint32_t i = 0; i < 3; ++i) {
    BlobParameters::Component& ball = blob.components.emplace_back();
    ball.center = Vec3(0.5 * i - 0.5, 0.2 * i, 0.0);
    ball.texture = i;
  }
  MeshParameters mesh;
  mesh.vertices = {{-2, -2, 0}, {2, -2, 0}, {0, 3, 0}, {0, 0, 2}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}};
  mesh.normals = {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}};
  mesh.face_normals = {{0, 1, 2}, {0, 1, 2}};
  mesh.uv = {Vec2(0, 0), Vec2(2, 0), Vec2(0, 4)};
  mesh.face_uvs = {{0, 1, 2}, {2, 1, 0}};
  mesh.face_textures = {{0, 1, 2}, {1, 1, 1}};
  for (const ShapePtr& shape : {make_sphere(Vec3(0.0), 1.0), make_torus(1.0, 0.5), make_box(Vec3(-1.0), Vec3(1.0)),
                                make_blob(blob), make_mesh(mesh)}) {
    expect_runs_of_points(shape);
    expect_runs_of_points(shape->placed(placement));
    expect_runs_of_points(shape->placed(placement)->inverted());
  }
}

TEST(Textures, OfAShapeWithoutAListAreTheObjects) {
  const ShapePtr sphere = make_sphere(Vec3(0.0), 1.0);
  const std::vector<TextureShare> shares = textures_at(*sphere, Vec3(1, 0, 0), {9.0, sphere.get(), 0, 0, {}});
  ASSERT_EQ(shares.size(), 1u);
  EXPECT_EQ(shares[0].texture, kObjectTexture);
  EXPECT_EQ(shares[0].weight, 1.0);
}

}  // namespace
}  // namespace firstlight::render
