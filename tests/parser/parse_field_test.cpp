#include "tests/parser/object_text.h"

#include <algorithm>
#include <vector>

namespace firstlight::parser {
namespace {

using render::Ray;
using render::Vec2;
using render::Vec3;

std::vector<render::Crossing> met(const render::ShapePtr& shape, const Ray& ray) {
  std::vector<render::Crossing> all;
  if (shape) shape->crossings(ray, all);
  return all;
}

std::vector<double> depths(const std::string& text, const Ray& ray) {
  std::vector<double> found;
  for (const render::Crossing& crossing : met(object_of(text).shape, ray)) found.push_back(crossing.depth);
  std::sort(found.begin(), found.end());
  return found;
}

const Ray kAlongX{Vec3(-5, 0.1, 0.1), Vec3(1, 0, 0)};

TEST(ParseIsosurface, DefaultsArePovRays) {
  const auto shape = object_of("isosurface { function { x + 2*y + 4*z } }").shape;
  EXPECT_EQ(shape->bounds(), render::Box3(Vec3(-1), Vec3(1)));
  EXPECT_TRUE(shape->inside(Vec3(-0.1, 0, 0)));
  EXPECT_FALSE(shape->inside(Vec3(0.1, 0, 0)));
  EXPECT_FALSE(shape->inside(Vec3(-1.1, 0, 0)));
  EXPECT_EQ(depths("isosurface { function { abs(x) - 0.5 } }", kAlongX).size(), 1u);
}

TEST(ParseIsosurface, AllItsWordsAreRead) {
  const std::string text =
      "#declare F = function (x, y, z) { abs(x)*y } isosurface { function { 10*F(x, 1, z) - 1 } contained_by { sphere "
      "{ y, 3 "
      "} } threshold 4 accuracy 0.0001 max_gradient 10 evaluate 1, 1.2, 0.9 open ";
  EXPECT_EQ(object_of(text + "}").shape->bounds(), render::Box3(Vec3(-3, -2, -3), Vec3(3, 4, 3)));
  EXPECT_EQ(depths(text + "max_trace 1 }", kAlongX).size(), 1u);
  const std::vector<double> two = depths(text + "max_trace 3 }", kAlongX);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_NEAR(two[0], 4.5, 1e-3);
  EXPECT_NEAR(two[1], 5.5, 1e-3);
  EXPECT_EQ(depths(text + "all_intersections }", kAlongX).size(), 2u);
  const auto boxed = object_of("isosurface { function { x } contained_by { box { <1, -2, 3>, <-1, 2, -3> } } }").shape;
  EXPECT_EQ(boxed->bounds(), render::Box3(Vec3(-1, -2, -3), Vec3(1, 2, 3)));
}

TEST(ParseIsosurface, ValuesWithoutSenseBecomeTheDefault) {
  const ParsedObject parsed =
      parsed_object("isosurface { function { abs(x) - 0.5 } accuracy 0 max_gradient -1 max_trace 99 }");
  EXPECT_NE(parsed.warnings.find("'accuracy' must be above 0"), std::string::npos);
  EXPECT_NE(parsed.warnings.find("'max_gradient' must be above 0"), std::string::npos);
  EXPECT_NE(parsed.warnings.find("'max_trace' is at most 10"), std::string::npos);
  EXPECT_EQ(met(parsed.object->shape, kAlongX).size(), 2u);
  EXPECT_NE(parsed_object("isosurface { box { -1, 1 } }").errors.find("'function'"), std::string::npos);
  EXPECT_NE(parsed_object("isosurface { function { x } accuracy 1/0 }").errors, "");
}

TEST(ParseParametric, TakesThreeFunctionsAndARange) {
  const render::Object object = object_of(
      "parametric { function { u }, function { v + 1 } function { u*v } <2, 1>, <-2, -1> contained_by { box { -3, 3 } "
      "} "
      "accuracy 0.01 max_gradient 3 precompute 9, x, z }");
  EXPECT_TRUE(object.patch);
  EXPECT_EQ(object.shape->bounds(), render::Box3(Vec3(-3), Vec3(3)));
  const Ray ray{Vec3(0.5, 1.5, -5), Vec3(0, 0, 1)};
  const auto all = met(object.shape, ray);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(all[0].depth, 5.25, 0.05);
  const Vec2 uv = object.shape->uv(ray.at(all[0].depth), all[0]);
  EXPECT_NEAR(uv.x, 0.5, 0.05);
  EXPECT_NEAR(uv.y, 0.5, 0.05);
}

TEST(ParseHeightField, TakesAPictureAndALevel) {
  const SceneFile picture("picture");
  EXPECT_NE(parsed_object("height_field { png \"" + picture.path() + "\" }").errors.find("cannot be used"),
            std::string::npos);
  const auto made = object_of("height_field { function 20, 30 { y } water_level 0.25 hierarchy off }").shape;
  EXPECT_NEAR(made->bounds().max.x, 1.0, 1e-12);
  EXPECT_NEAR(made->bounds().min.y, 0.25, 1e-6);
  EXPECT_TRUE(made->inside(Vec3(0.5, 0.8, 0.1)));  // the picture's upper rows lie where z is 1
  EXPECT_FALSE(made->inside(Vec3(0.5, 0.8, 0.9)));
  EXPECT_TRUE(made->inside(Vec3(0.5, 0.2, 0.9)));
  const auto narrow = parsed_object("height_field { function 1, 30 { x } }");
  EXPECT_EQ(narrow.errors, "");
  EXPECT_NE(narrow.warnings.find("nothing is seen of it"), std::string::npos);
  EXPECT_NE(parsed_object("height_field { function 65535, 65535 { x } }").errors.find("too many"), std::string::npos);
  EXPECT_NE(parsed_object("height_field { png \"no such picture.png\" }").errors, "");
}

}  // namespace
}  // namespace firstlight::parser
