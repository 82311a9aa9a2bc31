#include "tests/render/shape_test_support.h"

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

TEST(Textures, OfAShapeWithoutAListAreTheObjects) {
  std::vector<TextureShare> shares;
  const ShapePtr sphere = make_sphere(Vec3(0.0), 1.0);
  sphere->textures(Vec3(1, 0, 0), {9.0, sphere.get(), 0, 0, {}}, shares);
  ASSERT_EQ(shares.size(), 1u);
  EXPECT_EQ(shares[0].texture, kObjectTexture);
  EXPECT_EQ(shares[0].weight, 1.0);
}

}  // namespace
}  // namespace firstlight::render
