#include "tests/parser/object_text.h"

namespace firstlight::parser {
namespace {

using render::Vec2;
using render::Vec3;

constexpr std::string_view kTextures =
    "#declare A = texture { pigment { color rgb 1 } } #declare B = texture { pigment { color rgb 0 } } ";

std::string with_textures(std::string_view text) { return std::string(kTextures) + std::string(text); }

TEST(ParseForm, QuadricTakesTenNumbers) {
  const auto form = form_of<render::QuadricForm>("quadric { <1, 2, 3>, <4, 5, 6>, <7, 8, 9>, 10 }");
  EXPECT_EQ(form.square, Vec3(1, 2, 3));
  EXPECT_EQ(form.mixed, Vec3(4, 5, 6));
  EXPECT_EQ(form.linear, Vec3(7, 8, 9));
  EXPECT_EQ(form.constant, 10.0);
}

TEST(ParseForm, PolynomialTermsGoToTheirPlaces) {
  // poly { 2, <x^2, xy, xz, x, y^2, yz, y, z^2, z, 1> }
  const auto listed = form_of<render::PolynomialForm>("poly { 2, <1, 2, 3, 4, 5, 6, 7, 8, 9, 10> sturm }");
  const auto named = form_of<render::PolynomialForm>(
      "polynomial { 2, xyz(2, 0, 0): 1, xyz(1, 1, 0): 2 xyz(1, 0, 1): 3, xyz(1, 0, 0): 4, xyz(0, 2, 0): 5, "
      "xyz(0, 1, 1): 6, xyz(0, 1, 0): 7, xyz(0, 0, 2): 8, xyz(0, 0, 1): 9, xyz(0, 0, 0): 10 }");
  EXPECT_EQ(listed.order, 2);
  EXPECT_EQ(listed.coefficients, named.coefficients);
}

TEST(ParseForm, CubicAndQuarticHaveTheirOrders) {
  const auto cubic = form_of<render::PolynomialForm>(
      "cubic { <1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20> }");
  EXPECT_EQ(cubic.order, 3);
  EXPECT_EQ(cubic.coefficients.back(), 20.0);
  std::string numbers = "1";
  for (int i = 1; i < 35; ++i) numbers += ", 0";
  const auto quartic = form_of<render::PolynomialForm>("quartic { <" + numbers + "> }");
  EXPECT_EQ(quartic.order, 4);
  EXPECT_EQ(quartic.coefficients.size(), 35u);
}

TEST(ParseForm, PolynomialRefusesWhatHasNoPlace) {
  EXPECT_NE(parsed_object("poly { 36, <1> }").errors.find("must be from 2 to 35"), std::string::npos);
  EXPECT_NE(parsed_object("poly { 2, <1, 2> }").errors.find("expected"), std::string::npos);
  EXPECT_NE(parsed_object("polynomial { 2, xyz(2, 1, 0): 1 }").errors.find("add up to more"), std::string::npos);
  EXPECT_NE(parsed_object("polynomial { 2, xyz(-1, 1, 0): 1 }").errors.find("negative"), std::string::npos);
}

TEST(ParseForm, SuperellipsoidTakesTwoExponents) {
  const auto form = form_of<render::SuperellipsoidForm>("superellipsoid { <0.25, 0.5> }");
  EXPECT_EQ(form.east_west, 0.25);
  EXPECT_EQ(form.north_south, 0.5);
}

TEST(ParseForm, OvusWithATooLargeTopIsASphere) {
  const auto form = form_of<render::OvusForm>("ovus { 1, 0.75 }");
  EXPECT_EQ(form.bottom_radius, 1.0);
  EXPECT_EQ(form.top_radius, 0.75);
  const ParsedObject sphere = parsed_object("ovus { 1, 3 }");
  EXPECT_NE(sphere.warnings.find("the shape is a sphere"), std::string::npos);
  EXPECT_TRUE(sphere.object->shape);
  EXPECT_TRUE(sphere.object->extras->unrendered.empty());
  EXPECT_TRUE(sphere.object->shape->inside(Vec3(0, 3.9, 0)));
  EXPECT_NE(parsed_object("ovus { -1, 3 }").errors.find("must be positive"), std::string::npos);
}

TEST(ParseForm, JuliaFractalTakesItsFunctionAndSlice) {
  const auto plain = form_of<render::JuliaFractalForm>("julia_fractal { <-0.083, 0, -0.83, -0.025> }");
  EXPECT_EQ(plain.function, render::JuliaFunction::square);
  EXPECT_EQ(plain.algebra, render::JuliaFractalForm::Algebra::quaternion);
  EXPECT_EQ(plain.most_iterations, 20);
  EXPECT_EQ(plain.precision, 20.0);
  const auto form = form_of<render::JuliaFractalForm>(
      "julia_fractal { <1, 2, 3, 4> hypercomplex pwr(2, 3) max_iteration 8.9 precision 0.5 slice <0, 0, 0, 2>, 0.1 }");
  EXPECT_EQ(form.parameter, render::Vec4(1, 2, 3, 4));
  EXPECT_EQ(form.function, render::JuliaFunction::power);
  EXPECT_EQ(form.exponent, (std::pair<double, double>(2, 3)));
  EXPECT_EQ(form.most_iterations, 8);
  EXPECT_EQ(form.precision, 1.0);
  EXPECT_EQ(form.slice_normal, render::Vec4(0, 0, 0, 1));
  EXPECT_EQ(form.slice_distance, 0.1);
}

TEST(ParseForm, JuliaFractalKnowsAllFunctions) {
  for (const char* word : {"sqr", "cube"}) {
    form_of<render::JuliaFractalForm>("julia_fractal { <1, 0, 0, 0> quaternion " + std::string(word) + " }");
  }
  for (const char* word : {"exp", "reciprocal", "sin", "asin", "sinh", "asinh", "cos", "acos", "cosh", "acosh", "tan",
                           "atan", "tanh", "atanh", "ln"}) {
    const std::string text = std::string(word) + " hypercomplex }";
    EXPECT_NE(form_of<render::JuliaFractalForm>("julia_fractal { <1, 0, 0, 0> " + text).function,
              render::JuliaFunction::square);
    EXPECT_NE(parsed_object("julia_fractal { <1, 0, 0, 0> " + std::string(word) + " }").errors, "");
  }
}

TEST(ParseForm, JuliaFractalRefusesASliceWithoutDirection) {
  EXPECT_NE(parsed_object("julia_fractal { 1 slice 0, 1 }").errors.find("'slice' is zero"), std::string::npos);
  EXPECT_NE(parsed_object("julia_fractal { 1 slice <1, 0, 0, 0>, 1 }").errors.find("last component"),
            std::string::npos);
}

TEST(ParseForm, LatheTakesASplineAndItsPoints) {
  const auto form = form_of<render::LatheForm>("lathe { cubic_spline 4, <1, 0>, <2, 1>, <2, 2>, <0, 3> sturm on }");
  EXPECT_EQ(form.spline, render::ProfileSpline::cubic);
  ASSERT_EQ(form.points.size(), 4u);
  EXPECT_EQ(form.points[1], Vec2(2, 1));
  EXPECT_EQ(form_of<render::LatheForm>("lathe { 2 <1, 0> <2, 1> }").spline, render::ProfileSpline::linear);
}

TEST(ParseForm, LatheRefusesTooFewPointsAndPointsBehindTheAxis) {
  for (const char* start : {"linear_spline 1", "quadratic_spline 2", "cubic_spline 3"}) {
    EXPECT_NE(parsed_object("lathe { " + std::string(start) + ", <0, 0> }").errors.find("at least"), std::string::npos);
  }
  EXPECT_NE(parsed_object("lathe { bezier_spline 5, <0, 0> }").errors.find("four points"), std::string::npos);
  EXPECT_NE(parsed_object("lathe { 3, <0, 0>, <-1, 1>, <0, 2> }").errors.find("behind the axis"), std::string::npos);
}

TEST(ParseForm, SurfaceOfRevolutionMustRise) {
  const auto form = form_of<render::SurfaceOfRevolutionForm>("sor { 4, <0, -1>, <1, 0>, <1, 1>, <0, 2> open }");
  EXPECT_TRUE(form.open);
  EXPECT_EQ(form.points.size(), 4u);
  EXPECT_NE(parsed_object("sor { 3, <0, 0>, <1, 1>, <1, 2> }").errors.find("at least 4"), std::string::npos);
  EXPECT_NE(parsed_object("sor { 4, <0, 0>, <1, 2>, <1, 1>, <1, 3> }").errors.find("must rise"), std::string::npos);
}

TEST(ParseForm, PrismTakesSplineSweepAndHeights) {
  const auto form = form_of<render::PrismForm>(
      "prism { conic_sweep quadratic_spline 2, 1, 6, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0.5, 0.5>, <1, 0> open sturm }");
  EXPECT_EQ(form.sweep, render::PrismForm::Sweep::conic);
  EXPECT_EQ(form.spline, render::ProfileSpline::quadratic);
  EXPECT_EQ(form.low, 1.0);
  EXPECT_EQ(form.high, 2.0);
  EXPECT_TRUE(form.open);
  const auto bezier = form_of<render::PrismForm>(
      "prism { bezier_spline linear_sweep 0, 1, 8 <0, 0> <0, 1> <1, 1> <1, 0> <1, 0> <1, -1> <0, -1> <0, 0> }");
  EXPECT_EQ(bezier.points.size(), 8u);
}

TEST(ParseForm, LinearPrismThatIsNotClosedIsClosedWithAWarning) {
  const ParsedObject one = parsed_object("prism { 0, 1, 3, <0, 0>, <1, 0>, <0, 1> }");
  EXPECT_NE(one.warnings.find("it is closed"), std::string::npos);
  const auto& form = std::get<render::PrismForm>(one.object->extras->form->shape);
  EXPECT_EQ(form.points.back(), Vec2(0, 0));
  const ParsedObject two = parsed_object("prism { 0, 1, 7, <0, 0>, <1, 0>, <0, 1>, <0, 0>, <2, 2>, <3, 2>, <2, 3> }");
  EXPECT_EQ(std::get<render::PrismForm>(two.object->extras->form->shape).points.back(), Vec2(2, 2));
}

TEST(ParseForm, CurvedPrismThatIsNotClosedIsLeftOut) {
  const ParsedObject cubic =
      parsed_object("prism { cubic_spline 0, 1, 6, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <2, 1>, <3, 3> }");
  EXPECT_NE(cubic.warnings.find("left out"), std::string::npos);
  EXPECT_FALSE(cubic.object->extras->form);
  const ParsedObject bezier = parsed_object("prism { bezier_spline 0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }");
  EXPECT_FALSE(bezier.object->extras->form);
}

TEST(ParseForm, PolygonIsClosedWithAWarning) {
  const auto closed = form_of<render::PolygonForm>("polygon { 4, 0, x, y, 0 }");
  EXPECT_EQ(closed.points.size(), 4u);
  const ParsedObject open = parsed_object("polygon { 3, 0, x, y }");
  EXPECT_NE(open.warnings.find("not closed"), std::string::npos);
  EXPECT_EQ(std::get<render::PolygonForm>(open.object->extras->form->shape).points.size(), 4u);
  EXPECT_NE(parsed_object("polygon { 2, 0, x }").errors.find("at least 3"), std::string::npos);
}

TEST(ParseForm, PolygonThatIsNotFlatIsLeftOut) {
  for (const char* points : {"4, 0, x, 2*x, 0", "5, 0, x, x + y, y + z, 0"}) {
    const ParsedObject parsed = parsed_object("polygon { " + std::string(points) + " }");
    EXPECT_NE(parsed.warnings.find("left out"), std::string::npos) << points;
    EXPECT_FALSE(parsed.object->extras->form);
  }
}

TEST(ParseForm, SphereSweepTakesBalls) {
  const auto form = form_of<render::SphereSweepForm>(
      "sphere_sweep { b_spline 4, <0, 0, 0>, 1, <1, 0, 0>, 2, <2, 0, 0> 1 <3, 0, 0> 1 tolerance 0.1 }");
  EXPECT_EQ(form.spline, render::SphereSweepForm::Spline::b_spline);
  ASSERT_EQ(form.balls.size(), 4u);
  EXPECT_EQ(form.balls[1].radius, 2.0);
  EXPECT_EQ(form.tolerance, 0.1);
  EXPECT_EQ(form_of<render::SphereSweepForm>("sphere_sweep { linear_spline 2, 0, 1, x, 1 }").tolerance, 1e-6);
  EXPECT_NE(parsed_object("sphere_sweep { cubic_spline 3, 0, 1, x, 1, y, 1 }").errors.find("at least 4"),
            std::string::npos);
  EXPECT_NE(parsed_object("sphere_sweep { 2, 0, 1, x, 1 }").errors.find("'linear_spline'"), std::string::npos);
}

TEST(ParseForm, BicubicPatchTakesItsWordsAndPoints) {
  const std::string points = " <0, 0, 0>, x, 2*x, 3*x, y, x + y, 2*x + y, 3*x + y, z, x, y, z, 0, x, y, <7, 8, 9> }";
  const render::Object object = object_of(
      "bicubic_patch { type 1 flatness 0.1 u_steps 3 v_steps 4 accuracy 0.05 "
      "uv_vectors <0, 0>, <2, 0>, <2, 2>, <0, 2>" +
      points);
  const auto& form = std::get<render::BicubicPatchForm>(object.extras->form->shape);
  EXPECT_TRUE(object.patch);
  EXPECT_EQ(form.type, 1);
  EXPECT_EQ(form.flatness, 0.1);
  EXPECT_EQ(form.u_steps, 3);
  EXPECT_EQ(form.v_steps, 4);
  EXPECT_EQ(form.accuracy, 0.05);
  EXPECT_EQ(form.uv[2], Vec2(2, 2));
  EXPECT_EQ(form.points[1][2], Vec3(2, 1, 0));
  EXPECT_EQ(form.points[3][3], Vec3(7, 8, 9));
  const ParsedObject old = parsed_object("bicubic_patch { 3, 0.2, 1, 1" + points);
  EXPECT_NE(old.errors + old.warnings, "");
  EXPECT_NE(parsed_object("bicubic_patch { flatness 1" + points).errors.find("'type'"), std::string::npos);
}

TEST(ParseForm, TextTakesAFontAndALine) {
  const auto form = form_of<render::TextForm>("text { internal 2 \"Abc\", 0.5, <0.1, 0, 0> }");
  EXPECT_EQ(form.builtin_font, 2);
  EXPECT_EQ(form.text, "Abc");
  EXPECT_EQ(form.thickness, 0.5);
  EXPECT_EQ(form.offset, Vec3(0.1, 0, 0));
  EXPECT_EQ(form_of<render::TextForm>("text { internal 99 \"a\" 1 0 }").builtin_font, 0);
  EXPECT_NE(parsed_object("text { ttf \"no such font\", \"a\", 1, 0 }").errors.find("no such font"), std::string::npos);
  EXPECT_NE(parsed_object("text { \"a\", 1, 0 }").errors.find("'ttf' or 'internal'"), std::string::npos);
}

TEST(ParseForm, FontIsFoundWithoutItsExtension) {
  const std::string name = "firstlight_font_" + std::to_string(getpid());
  const std::filesystem::path path = std::filesystem::temp_directory_path() / (name + ".ttf");
  std::ofstream(path) << "font";
  const auto form = form_of<render::TextForm>("text { ttf \"" + name + "\", \"a\", 1, 0 }");
  EXPECT_EQ(std::filesystem::path(form.font_file).filename(), name + ".ttf");
  std::filesystem::remove(path);
}

TEST(ParseForm, BlobTakesComponentsWithSurfacesOfTheirOwn) {
  const auto form = form_of<render::BlobForm>(
      with_textures("blob { threshold 0.6 sphere { x, 2, strength 1.5 scale 2 texture { A } translate y } "
                    "cylinder { 0, y, 0.5, -1 pigment { color rgb x } finish { phong 1 } } component 1, 2, <1, 2, 3> "
                    "sturm hierarchy off }"));
  EXPECT_EQ(form.threshold, 0.6);
  ASSERT_EQ(form.components.size(), 3u);
  const auto& sphere = form.components[0];
  EXPECT_EQ(sphere.kind, render::BlobForm::Component::Kind::sphere);
  EXPECT_EQ(sphere.center, Vec3(1, 0, 0));
  EXPECT_EQ(sphere.radius, 2.0);
  EXPECT_EQ(sphere.strength, 1.5);
  EXPECT_EQ(sphere.placement.point(Vec3(1, 0, 0)), Vec3(2, 1, 0));
  EXPECT_TRUE(sphere.texture);
  const auto& cylinder = form.components[1];
  EXPECT_EQ(cylinder.kind, render::BlobForm::Component::Kind::cylinder);
  EXPECT_EQ(cylinder.end, Vec3(0, 1, 0));
  EXPECT_EQ(cylinder.strength, -1.0);
  EXPECT_EQ(cylinder.texture->layers.front().finish->phong, 1.0);
  EXPECT_EQ(form.components[2].center, Vec3(1, 2, 3));
  EXPECT_EQ(form.components[2].strength, 1.0);
  EXPECT_EQ(form.components[2].radius, 2.0);
  EXPECT_FALSE(form.components[2].texture);
}

TEST(ParseForm, BlobNeedsAComponentWithLength) {
  EXPECT_NE(parsed_object("blob { threshold 1 }").errors.find("at least one"), std::string::npos);
  EXPECT_NE(parsed_object("blob { cylinder { x, x, 1, 1 } }").errors.find("no length"), std::string::npos);
}

TEST(ParseForm, DegenerateShapesOfGuessedNumbersAreLeftOut) {
  const auto result = described(
      "#declare B = blob { sphere { 0, 2, 1 } } #declare P = trace(B, 5*y, -y); cylinder { P, trace(B, 5*y, -y), 1 } "
      "blob { #if (inside(B, 5)) sphere { 0, 1, 1 } #end } sphere { 0, 1 }");
  EXPECT_EQ(errors(result), "");
  EXPECT_NE(warnings(result).find("'cylinder' has no length"), std::string::npos);
  EXPECT_NE(warnings(result).find("'blob' needs at least one"), std::string::npos);
}

TEST(ParseForm, DescribedShapeSaysThatItCannotBeRenderedWhereItIsUsed) {
  const auto unused = load("#declare B = blob { sphere { 0, 1, 1 } } sphere { 0, 1 }");
  EXPECT_TRUE(unused.scene);
  const auto used = load("#declare B = blob { sphere { 0, 1, 1 } }\nobject { B }");
  EXPECT_FALSE(used.scene);
  EXPECT_NE(errors(used).find("'blob' cannot be rendered"), std::string::npos);
  EXPECT_EQ(used.summary.objects, 1u);
}

TEST(ParseForm, DescribedShapeTakesModifiersAsAnyObject) {
  const render::Object object =
      object_of("prism { 0, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> rotate 90*x inverse hollow }");
  EXPECT_TRUE(object.inverted);
  EXPECT_EQ(object.hollow, render::Object::Hollow::yes);
  EXPECT_EQ(object.word, "prism");
  EXPECT_EQ(spelled(object.extras->unrendered), "prism");
}

}  // namespace
}  // namespace firstlight::parser
