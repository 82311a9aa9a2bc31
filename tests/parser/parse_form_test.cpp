#include "tests/parser/object_text.h"
#include "tests/render/textures_at.h"

namespace firstlight::parser {
namespace {

using render::Vec2;
using render::Vec3;

constexpr std::string_view kTextures =
    "#declare A = texture { pigment { color rgb 1 } } #declare B = texture { pigment { color rgb 0 } } ";

std::string with_textures(std::string_view text) { return std::string(kTextures) + std::string(text); }

TEST(ParseForm, QuadricTakesTenNumbers) {
  const auto shape = object_of("quadric { <1, 0, 4>, <0, 0, 0>, <0, -1, 0>, -3 }").shape;  // x^2 + 4 z^2 - y - 3
  EXPECT_TRUE(shape->inside(Vec3(1.9, 1, 0)));
  EXPECT_FALSE(shape->inside(Vec3(2.1, 1, 0)));
  EXPECT_TRUE(shape->inside(Vec3(0, 1, 0.9)));
  EXPECT_FALSE(shape->inside(Vec3(0, 1, 1.1)));
  EXPECT_FALSE(shape->inside(Vec3(0, -3.1, 0)));
}

TEST(ParseForm, PolynomialTermsGoToTheirPlaces) {
  // poly { 2, <x^2, xy, xz, x, y^2, yz, y, z^2, z, 1> }
  const auto listed = object_of("poly { 2, <1, 2, 3, 4, 5, 6, 7, 8, 9, -10> sturm }").shape;
  const auto named =
      object_of(
          "polynomial { 2, xyz(2, 0, 0): 1, xyz(1, 1, 0): 2 xyz(1, 0, 1): 3, xyz(1, 0, 0): 4, xyz(0, 2, 0): 5, "
          "xyz(0, 1, 1): 6, xyz(0, 1, 0): 7, xyz(0, 0, 2): 8, xyz(0, 0, 1): 9, xyz(0, 0, 0): -10 }")
          .shape;
  for (double x = -2.0; x < 2.0; x += 0.3) {
    for (double y = -2.0; y < 2.0; y += 0.3) {
      const Vec3 p(x, y, 0.4);
      const double value = x * x + 2 * x * y + 3 * x * 0.4 + 4 * x + 5 * y * y + 6 * y * 0.4 + 7 * y + 8 * 0.16 + 3.6 - 10;
      EXPECT_EQ(listed->inside(p), value < 1e-4) << p;
      EXPECT_EQ(named->inside(p), listed->inside(p)) << p;
    }
  }
}

TEST(ParseForm, CubicAndQuarticHaveTheirOrders) {
  const auto cubic = object_of("cubic { <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -8> }").shape;
  EXPECT_TRUE(cubic->inside(Vec3(1.9, 5, 7)));
  EXPECT_FALSE(cubic->inside(Vec3(2.1, 5, 7)));
  std::string numbers = "1";
  for (int i = 1; i < 34; ++i) numbers += ", 0";
  const auto quartic = object_of("quartic { <" + numbers + ", -16> }").shape;
  EXPECT_TRUE(quartic->inside(Vec3(-1.9, 5, 7)));
  EXPECT_FALSE(quartic->inside(Vec3(-2.1, 5, 7)));
}

TEST(ParseForm, PolynomialRefusesWhatHasNoPlace) {
  EXPECT_NE(parsed_object("poly { 36, <1> }").errors.find("must be from 2 to 35"), std::string::npos);
  EXPECT_NE(parsed_object("poly { 2, <1, 2> }").errors.find("expected"), std::string::npos);
  EXPECT_NE(parsed_object("polynomial { 2, xyz(2, 1, 0): 1 }").errors.find("add up to more"), std::string::npos);
  EXPECT_NE(parsed_object("polynomial { 2, xyz(-1, 1, 0): 1 }").errors.find("negative"), std::string::npos);
}

TEST(ParseForm, SuperellipsoidTakesTwoExponents) {
  const auto shape = object_of("superellipsoid { <0.1, 1> }").shape;  // a box from above, a ball from the side
  EXPECT_TRUE(shape->inside(Vec3(0.9, 0.9, 0)));
  EXPECT_FALSE(shape->inside(Vec3(0.9, 0, 0.9)));
}

TEST(ParseForm, OvusWithATooLargeTopIsASphere) {
  const auto egg = object_of("ovus { 1, 0.75 }").shape;
  EXPECT_EQ(egg->bounds().min.y, -1.0);
  EXPECT_EQ(egg->bounds().max.y, 1.75);
  const ParsedObject sphere = parsed_object("ovus { 1, 3 }");
  EXPECT_NE(sphere.warnings.find("the shape is a sphere"), std::string::npos);
  EXPECT_TRUE(sphere.object->shape);
  EXPECT_TRUE(sphere.object->extras->unrendered.empty());
  EXPECT_TRUE(sphere.object->shape->inside(Vec3(0, 3.9, 0)));
  EXPECT_NE(parsed_object("ovus { -1, 3 }").errors.find("must be positive"), std::string::npos);
}

TEST(ParseForm, JuliaFractalRefusesASliceWithoutDirection) {
  EXPECT_NE(parsed_object("julia_fractal { 1 slice 0, 1 }").errors.find("'slice' is zero"), std::string::npos);
  EXPECT_NE(parsed_object("julia_fractal { 1 slice <1, 0, 0, 0>, 1 }").errors.find("last component"),
            std::string::npos);
}

TEST(ParseForm, LatheTakesASplineAndItsPoints) {
  const auto cubic = object_of("lathe { cubic_spline 4, <1, 0>, <2, 1>, <2, 2>, <0, 3> sturm on }").shape;
  EXPECT_EQ(cubic->bounds().min.y, 1.0);
  EXPECT_EQ(cubic->bounds().max.y, 2.0);
  EXPECT_EQ(object_of("lathe { 2 <1, 0> <2, 1> }").shape->bounds(), render::Box3(Vec3(-2, 0, -2), Vec3(2, 1, 2)));
}

TEST(ParseForm, LatheRefusesTooFewPointsAndPointsBehindTheAxis) {
  for (const char* start : {"linear_spline 1", "quadratic_spline 2", "cubic_spline 3"}) {
    EXPECT_NE(parsed_object("lathe { " + std::string(start) + ", <0, 0> }").errors.find("at least"), std::string::npos);
  }
  EXPECT_NE(parsed_object("lathe { bezier_spline 5, <0, 0> }").errors.find("four points"), std::string::npos);
  EXPECT_NE(parsed_object("lathe { 3, <0, 0>, <-1, 1>, <0, 2> }").errors.find("behind the axis"), std::string::npos);
}

TEST(ParseForm, SurfaceOfRevolutionMustRise) {
  const auto shape = object_of("sor { 4, <0, -1>, <1, 0>, <1, 1>, <0, 2> open }").shape;
  EXPECT_TRUE(shape->inside(Vec3(0.9, 0.5, 0)));
  EXPECT_EQ(shape->bounds().max.y, 1.0);
  EXPECT_NE(parsed_object("sor { 3, <0, 0>, <1, 1>, <1, 2> }").errors.find("at least 4"), std::string::npos);
  EXPECT_NE(parsed_object("sor { 4, <0, 0>, <1, 2>, <1, 1>, <1, 3> }").errors.find("must rise"), std::string::npos);
}

TEST(ParseForm, PrismTakesSplineSweepAndHeights) {
  const auto cone = object_of("prism { conic_sweep 2, 1, 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> open sturm }").shape;
  EXPECT_TRUE(cone->inside(Vec3(1.8, 1.9, 1.8)));
  EXPECT_FALSE(cone->inside(Vec3(1.8, 1.1, 1.8)));
  EXPECT_FALSE(cone->inside(Vec3(0.1, 0.9, 0.1)));
  const auto bezier =
      object_of(
          "prism { bezier_spline linear_sweep 0, 1, 8 <0, 0> <0, 1> <1, 1> <1, 0> <1, 0> <1, -1> <0, -1> <0, 0> }")
          .shape;
  EXPECT_TRUE(bezier->inside(Vec3(0.5, 0.5, 0.7)));
  EXPECT_FALSE(bezier->inside(Vec3(0.5, 0.5, 0.8)));
}

TEST(ParseForm, LinearPrismThatIsNotClosedIsClosedWithAWarning) {
  const ParsedObject one = parsed_object("prism { 0, 1, 3, <0, 0>, <1, 0>, <0, 1> }");
  EXPECT_NE(one.warnings.find("it is closed"), std::string::npos);
  EXPECT_TRUE(one.object->shape->inside(Vec3(0.1, 0.5, 0.5)));
  EXPECT_FALSE(one.object->shape->inside(Vec3(-0.1, 0.5, 0.5)));
  const ParsedObject two = parsed_object("prism { 0, 1, 7, <0, 0>, <1, 0>, <0, 1>, <0, 0>, <2, 2>, <3, 2>, <2, 3> }");
  EXPECT_TRUE(two.object->shape->inside(Vec3(2.1, 0.5, 2.5)));
}

TEST(ParseForm, CurvedPrismThatIsNotClosedIsLeftOut) {
  const ParsedObject cubic =
      parsed_object("prism { cubic_spline 0, 1, 6, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <2, 1>, <3, 3> }");
  EXPECT_NE(cubic.warnings.find("left out"), std::string::npos);
  EXPECT_FALSE(cubic.object->shape);
  const ParsedObject bezier = parsed_object("prism { bezier_spline 0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }");
  EXPECT_FALSE(bezier.object->shape);
}

TEST(ParseForm, PolygonIsClosedWithAWarning) {
  EXPECT_TRUE(object_of("polygon { 4, 0, x, y, 0 }").shape);
  const ParsedObject open = parsed_object("polygon { 3, 0, x, y }");
  EXPECT_NE(open.warnings.find("not closed"), std::string::npos);
  EXPECT_TRUE(open.object->shape);
  EXPECT_NE(parsed_object("polygon { 2, 0, x }").errors.find("at least 3"), std::string::npos);
}

TEST(ParseForm, PolygonThatIsNotFlatIsLeftOut) {
  for (const char* points : {"4, 0, x, 2*x, 0", "5, 0, x, x + y, y + z, 0"}) {
    const ParsedObject parsed = parsed_object("polygon { " + std::string(points) + " }");
    EXPECT_NE(parsed.warnings.find("left out"), std::string::npos) << points;
    EXPECT_FALSE(parsed.object->shape);
  }
}

TEST(ParseForm, SphereSweepTakesBalls) {
  const std::string balls = "4, <0, 0, 0>, 1, <1, 0, 0>, 2, <2, 0, 0> 1 <3, 0, 0> 1 ";
  const auto shape = object_of("sphere_sweep { b_spline " + balls + "tolerance 0.1 }").shape;
  EXPECT_EQ(shape->given_bounds(), render::Box3(Vec3(-1, -2, -2), Vec3(4, 2, 2)));
  EXPECT_TRUE(shape->inside(Vec3(1, 1.4, 0)));
  EXPECT_FALSE(shape->inside(Vec3(1, 1.9, 0)));
  EXPECT_TRUE(object_of("sphere_sweep { cubic_spline " + balls + "}").shape->inside(Vec3(1, 1.9, 0)));
  std::vector<render::Crossing> near;
  shape->crossings({Vec3(-0.05, 0, 0) + Vec3(1, 0, 0), Vec3(1, 0, 0)}, near);
  for (const render::Crossing& crossing : near) EXPECT_GT(crossing.depth, 0.1);
  EXPECT_TRUE(object_of("sphere_sweep { linear_spline 2, 0, 1, x, 1 }").shape->inside(Vec3(0.5, 0.9, 0)));
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
  EXPECT_TRUE(object.patch);
  EXPECT_EQ(object.shape->bounds(), render::Box3(Vec3(0, 0, 0), Vec3(7, 8, 9)));
  const ParsedObject old = parsed_object("bicubic_patch { 3, 0.2, 1, 1" + points);
  EXPECT_NE(old.errors + old.warnings, "");
  EXPECT_NE(parsed_object("bicubic_patch { flatness 1" + points).errors.find("'type'"), std::string::npos);
}

TEST(ParseForm, TextTakesAFontAndALine) {
  const render::Object text = object_of("text { internal 2 \"A bc\", 0.5, <0.1, 0, 0> }");
  EXPECT_EQ(text.kind, render::Object::Kind::union_);
  ASSERT_EQ(text.children->size(), 3u) << "a blank is no letter";
  const render::Box3 letter = text.children->front().shape->bounds();
  EXPECT_NEAR(letter.max.z, 0.5, 1e-9);
  EXPECT_GT(letter.max.y, 0.5);
  EXPECT_EQ(object_of("text { internal 99 \"a\" 1 0 }").children->size(), 1u);
  EXPECT_EQ(object_of("text { ttf \"timrom\" \"\" 1 0 }").children->size(), 0u);
  EXPECT_NE(parsed_object("text { ttf \"no such font\", \"a\", 1, 0 }").errors.find("no such font"), std::string::npos);
  EXPECT_NE(parsed_object("text { \"a\", 1, 0 }").errors.find("'ttf' or 'internal'"), std::string::npos);
}

TEST(ParseForm, FontThatIsNoneIsRefused) {
  const std::string name = "firstlight_font_" + std::to_string(getpid());
  const std::filesystem::path path = std::filesystem::temp_directory_path() / (name + ".ttf");
  std::ofstream(path) << "font";
  EXPECT_NE(parsed_object("text { ttf \"" + name + "\", \"a\", 1, 0 }").errors.find("no TrueType font"),
            std::string::npos);
  std::filesystem::remove(path);
}

TEST(ParseForm, BlobTakesComponentsWithSurfacesOfTheirOwn) {
  const render::Object object =
      object_of(with_textures("blob { threshold 0.6 sphere { x, 2, strength 1.5 scale 2 texture { A } translate y } "
                              "cylinder { 0, y, 0.5, -1 pigment { color rgb x } finish { phong 1 } } "
                              "component 1, 2, <11, 12, 13> sturm hierarchy off }"));
  ASSERT_EQ(object.extras->shape_textures.size(), 2u);
  EXPECT_EQ(object.extras->shape_textures[1]->layers.front().finish->phong, 1.0);
  EXPECT_TRUE(object.shape->inside(Vec3(2, 1, 0) + Vec3(1, 0, 0)));
  EXPECT_TRUE(object.shape->inside(Vec3(11, 12, 13)));
  EXPECT_FALSE(object.shape->inside(Vec3(11, 12, 13) + Vec3(1.3, 0, 0)));
  std::vector<render::TextureShare> shares = render::textures_at(*object.shape, Vec3(11, 12, 13));
  ASSERT_EQ(shares.size(), 1u);
  EXPECT_EQ(shares[0].texture, render::kObjectTexture);
  shares = render::textures_at(*object.shape, Vec3(3, 1, 0));
  ASSERT_EQ(shares.size(), 1u);
  EXPECT_EQ(shares[0].texture, 0u);
}

TEST(ParseForm, BlobNeedsAComponentWithLength) {
  EXPECT_NE(parsed_object("blob { threshold 1 }").errors.find("at least one"), std::string::npos);
  EXPECT_NE(parsed_object("blob { cylinder { x, x, 1, 1 } }").errors.find("no length"), std::string::npos);
}

TEST(ParseForm, JuliaFractalTakesItsWords) {
  const std::string start = "julia_fractal { <-0.08, 0, -0.8, -0.02> ";
  const render::Object object = object_of(start + "quaternion cube max_iteration 5.9 precision 50 slice <0, 0, 0.1, 1>, 0.1 "
                                                  "rotate 90*x inverse hollow }");
  EXPECT_TRUE(object.inverted);
  EXPECT_EQ(object.hollow, render::Object::Hollow::yes);
  EXPECT_EQ(object.word, "julia_fractal");
  EXPECT_TRUE(object.shape->inside(Vec3(0.0)));
  for (const char* function : {"sqr", "cube", "exp", "reciprocal", "sin", "asin", "sinh", "asinh", "cos", "acos", "cosh",
                               "acosh", "tan", "atan", "tanh", "atanh", "ln", "pwr(2, 0.5)"}) {
    EXPECT_TRUE(object_of(start + "hypercomplex " + function + " }").shape) << function;
  }
  EXPECT_NE(parsed_object(start + "exp }").errors.find("must be 'hypercomplex'"), std::string::npos);
  EXPECT_NE(parsed_object(start + "slice <0, 0, 1, 0>, 0 }").errors.find("last component"), std::string::npos);
  EXPECT_NE(parsed_object(start + "max_iteration 1e9 }").errors.find("at most"), std::string::npos);
}

TEST(ParseForm, ShapesAreAskedWhereTheyAre) {
  const auto result = load(
      "#declare B = julia_fractal { <-0.08, 0, -0.8, -0.02> translate 3*x } #declare P = trace(B, <3, 5, 0>, -y); "
      "#if (!inside(B, 3*x) | inside(B, 0) | abs(P.x - 3) > 0.001 | min_extent(B).x < 1) #error \"elsewhere\" #end "
      "sphere { P, 1 }");
  EXPECT_EQ(errors(result), "");
}

}  // namespace
}  // namespace firstlight::parser
