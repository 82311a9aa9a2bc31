#include "tests/parser/object_text.h"

namespace firstlight::parser {
namespace {

using render::IsosurfaceForm;
using render::ParametricForm;
using render::Vec2;
using render::Vec3;

double value(const render::FunctionPtr& function, std::array<double, 3> arguments) {
  render::Evaluation evaluation;
  std::array<double, render::Function::kMostResults> results{};
  function->evaluate(arguments.data(), results.data(), evaluation);
  return results[0];
}

TEST(ParseIsosurface, DefaultsArePovRays) {
  const auto form = form_of<IsosurfaceForm>("isosurface { function { x + 2*y + 4*z } }");
  EXPECT_EQ(value(form.function, {1, 1, 1}), 7.0);
  EXPECT_EQ(form.threshold, 0.0);
  EXPECT_EQ(form.accuracy, 0.001);
  EXPECT_EQ(form.max_gradient, 1.1);
  EXPECT_EQ(form.max_trace, 1);
  EXPECT_FALSE(form.open || form.evaluate);
  EXPECT_EQ(std::get<render::ContainerBox>(form.container).low, Vec3(-1, -1, -1));
}

TEST(ParseIsosurface, AllItsWordsAreRead) {
  const auto form = form_of<IsosurfaceForm>(
      "#declare F = function (x, y, z) { x*y*z } isosurface { function { F(x, y, z) - 1 } contained_by { sphere { y, 3 "
      "} } "
      "threshold 0.5 accuracy 0.01 max_gradient 4 evaluate 1, 1.2, 0.9 open max_trace 3 }");
  EXPECT_EQ(value(form.function, {1, 2, 3}), 5.0);
  EXPECT_EQ(std::get<render::ContainerSphere>(form.container).radius, 3.0);
  EXPECT_EQ(form.threshold, 0.5);
  EXPECT_EQ(form.accuracy, 0.01);
  EXPECT_EQ(form.max_gradient, 4.0);
  EXPECT_EQ((*form.evaluate)[1], 1.2);
  EXPECT_TRUE(form.open);
  EXPECT_EQ(form.max_trace, 3);
  const auto boxed = form_of<IsosurfaceForm>(
      "isosurface { function { x } contained_by { box { <1, -2, 3>, <-1, 2, -3> } } all_intersections }");
  EXPECT_EQ(std::get<render::ContainerBox>(boxed.container).low, Vec3(-1, -2, -3));
  EXPECT_EQ(boxed.max_trace, IsosurfaceForm::kMostTraces);
}

TEST(ParseIsosurface, ValuesWithoutSenseBecomeTheDefault) {
  const ParsedObject parsed = parsed_object("isosurface { function { x } accuracy 0 max_gradient -1 max_trace 99 }");
  const auto& form = std::get<IsosurfaceForm>(parsed.object->extras->form->shape);
  EXPECT_EQ(form.accuracy, 0.001);
  EXPECT_EQ(form.max_gradient, 1.1);
  EXPECT_EQ(form.max_trace, 10);
  EXPECT_NE(parsed.warnings.find("'accuracy' must be above 0"), std::string::npos);
  EXPECT_EQ(spelled(parsed.object->extras->unrendered), "isosurface");
  EXPECT_NE(parsed_object("isosurface { box { -1, 1 } }").errors.find("'function'"), std::string::npos);
}

TEST(ParseParametric, TakesThreeFunctionsAndARange) {
  const std::string text =
      "parametric { function { u*v }, function { u + v } function { v } <3, 1>, <0, 2> contained_by { box { -3, 3 } } "
      "accuracy 0.01 max_gradient 5 precompute 15, x, z }";
  const render::Object object = object_of(text);
  const auto form = form_of<ParametricForm>(text);
  EXPECT_TRUE(object.patch);
  EXPECT_EQ(value(form.functions[0], {2, 3, 0}), 6.0);
  EXPECT_EQ(value(form.functions[2], {2, 3, 0}), 3.0);
  EXPECT_EQ(form.low, Vec2(0, 1));
  EXPECT_EQ(form.high, Vec2(3, 2));
  EXPECT_EQ(form.accuracy, 0.01);
  EXPECT_EQ(form.max_gradient, 5.0);
  EXPECT_EQ(form.precompute_depth, 15);
  EXPECT_EQ(form.precompute, (std::array<bool, 3>{true, false, true}));
  EXPECT_EQ(std::get<render::ContainerBox>(form.container).high, Vec3(3, 3, 3));
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
  EXPECT_NE(parsed_object("height_field { function 1, 30 { x } }").errors, "");
  EXPECT_NE(parsed_object("height_field { function 65535, 65535 { x } }").errors.find("too many"), std::string::npos);
  EXPECT_NE(parsed_object("height_field { png \"no such picture.png\" }").errors, "");
}

}  // namespace
}  // namespace firstlight::parser
