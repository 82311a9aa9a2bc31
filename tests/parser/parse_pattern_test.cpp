#include "render/scene/object.h"
#include "tests/parser/surface_text.h"

namespace firstlight::parser {
namespace {

using render::FractalParameters;
using render::PatternKind;
using render::Vec2;
using render::Vec3;
using render::WaveForm;

PatternKind kind_of(std::string_view words) { return pigment_of(words).pattern->kind; }

TEST(ParsePattern, PatternsWithoutParametersAreKnownByTheirWord) {
  const std::pair<const char*, PatternKind> kinds[] = {{"agate", PatternKind::agate},
                                                       {"aoi", PatternKind::aoi},
                                                       {"boxed", PatternKind::boxed},
                                                       {"bozo", PatternKind::bozo},
                                                       {"bumps", PatternKind::bumps},
                                                       {"cells", PatternKind::cells},
                                                       {"crackle", PatternKind::crackle},
                                                       {"cylindrical", PatternKind::cylindrical},
                                                       {"dents", PatternKind::dents},
                                                       {"granite", PatternKind::granite},
                                                       {"leopard", PatternKind::leopard},
                                                       {"marble", PatternKind::marble},
                                                       {"onion", PatternKind::onion},
                                                       {"planar", PatternKind::planar},
                                                       {"quilted", PatternKind::quilted},
                                                       {"radial", PatternKind::radial},
                                                       {"ripples", PatternKind::ripples},
                                                       {"spherical", PatternKind::spherical},
                                                       {"spotted", PatternKind::spotted},
                                                       {"waves", PatternKind::waves},
                                                       {"wood", PatternKind::wood},
                                                       {"wrinkles", PatternKind::wrinkles},
                                                       {"checker", PatternKind::checker},
                                                       {"brick", PatternKind::brick},
                                                       {"hexagon", PatternKind::hexagon},
                                                       {"square", PatternKind::square},
                                                       {"triangular", PatternKind::triangular},
                                                       {"cubic", PatternKind::cubic},
                                                       {"pavement", PatternKind::pavement}};
  for (const auto& [word, kind] : kinds) EXPECT_EQ(kind_of(word), kind) << word;
}

TEST(ParsePattern, WhatIsNotRenderedIsToldAtItsPlaceWhenUsed) {
  EXPECT_EQ(unrendered("#declare F = finish { subsurface { } } sphere { 0, 1 finish { F } }"), "subsurface ");
  EXPECT_EQ(unrendered("#declare F = finish { subsurface { } } sphere { 0, 1 pigment { gradient x } }"), "");
  EXPECT_EQ(unrendered("sphere { 0, 1 pigment { gradient x turbulence 0.5 } }"), "");
  EXPECT_EQ(unrendered("sphere { 0, 1 pigment { gradient x warp { repeat x } } }"), "");
  EXPECT_EQ(unrendered("sphere { 0, 1 pigment { rgb 1 turbulence 1 } }"), "");
  EXPECT_EQ(errors(load("sphere { 0, 1 finish { subsurface { } } }")),
            "'subsurface' cannot be rendered by this version of Firstlight\n");
}

TEST(ParsePattern, EveryPatternTellsWhetherItIsRendered) {
  for (int i = static_cast<int>(PatternKind::plain) + 1; i <= static_cast<int>(PatternKind::wrinkles); ++i) {
    const auto kind = static_cast<PatternKind>(i);
    EXPECT_EQ(render::spelling(render::feature_of(kind)), spelling(kind));
  }
}

TEST(ParsePattern, CrackleHasFormMetricOffsetAndSolid) {
  const auto plain = pigment_of("crackle");
  const auto& bare = parameters<render::CrackleParameters>(plain.pattern);
  EXPECT_EQ(bare.form, Vec3(-1, 1, 0));
  EXPECT_EQ(bare.metric, 2.0);
  EXPECT_EQ(bare.offset, 0.0);
  EXPECT_FALSE(bare.solid);
  const auto pigment = pigment_of("crackle form <1, 2, 3> metric 1 offset 0.5 solid");
  const auto& full = parameters<render::CrackleParameters>(pigment.pattern);
  EXPECT_EQ(full.form, Vec3(1, 2, 3));
  EXPECT_EQ(full.metric, 1.0);
  EXPECT_EQ(full.offset, 0.5);
  EXPECT_TRUE(full.solid);
  EXPECT_TRUE(says(pigment_error("bozo metric 1"), "'metric' is for 'facets' and 'crackle' only"));
  EXPECT_TRUE(says(pigment_error("bozo solid"), "'solid' is for 'crackle' only"));
}

TEST(ParsePattern, BrickKeepsItsSizeWhenNamedAgain) {
  const auto pigment = pigment_of("brick rgb 1, rgb x brick_size <1, 2, 3> mortar 0.25");
  EXPECT_EQ(parameters<render::BrickParameters>(pigment.pattern).size, Vec3(1, 2, 3));
  EXPECT_EQ(parameters<render::BrickParameters>(pigment.pattern).mortar, 0.25);
  EXPECT_EQ(pigment.pattern->map.at(1).color.rgb, render::Rgb(1, 0, 0));
  const auto scene = surface_scene(
      "#declare P = pigment { brick brick_size 2 } sphere { 0, 1 pigment { P brick rgb 1 } } sphere { 0, 1 pigment { "
      "brick } }");
  EXPECT_EQ(parameters<render::BrickParameters>(layer_of(*scene, 0).pigment.pattern).size, Vec3(2, 2, 2));
  EXPECT_EQ(parameters<render::BrickParameters>(layer_of(*scene, 1).pigment.pattern).size, Vec3(8, 3, 4.5));
  EXPECT_TRUE(says(pigment_error("bozo brick_size 1"), "'brick_size' is for 'brick' only"));
}

TEST(ParsePattern, FractalsHaveExponentsAndTypesOfColoring) {
  const auto mandel = pigment_of("mandel 50 exponent 4 exterior 2, 0.5 interior 3, 2").pattern;
  EXPECT_EQ(mandel->kind, PatternKind::mandel);
  const auto& values = parameters<FractalParameters>(mandel);
  EXPECT_EQ(values.iterations, 50);
  EXPECT_EQ(values.exponent, 4);
  EXPECT_EQ(values.exterior_type, 2);
  EXPECT_EQ(values.exterior_factor, 0.5);
  EXPECT_EQ(values.interior_type, 3);
  EXPECT_EQ(values.interior_factor, 2.0);
  const auto julia = pigment_of("julia <0.3, 0.6>, 20").pattern;
  EXPECT_EQ(parameters<FractalParameters>(julia).start, Vec2(0.3, 0.6));
  EXPECT_TRUE(parameters<FractalParameters>(julia).julia);
  EXPECT_EQ(parameters<FractalParameters>(julia).exponent, 2);
  EXPECT_EQ(parameters<FractalParameters>(julia).exterior_type, 1);
  const auto magnet = pigment_of("magnet 2 julia <1, 2>, 30").pattern;
  EXPECT_EQ(parameters<FractalParameters>(magnet).magnet, 2);
  EXPECT_EQ(parameters<FractalParameters>(magnet).iterations, 30);
  EXPECT_FALSE(parameters<FractalParameters>(pigment_of("magnet 1 mandel 9").pattern).julia);
  EXPECT_TRUE(says(pigment_error("magnet 3 mandel 9"), "must be 1 or 2"));
  EXPECT_TRUE(says(pigment_error("mandel 9 exterior 9, 1"), "from 0 to 8"));
  EXPECT_TRUE(says(pigment_error("mandel 9 interior 7, 1"), "from 0 to 6"));
  EXPECT_TRUE(says(pigment_error("magnet 1 mandel 9 exponent 3"), "'exponent' is for 'mandel' and 'julia' only"));
  EXPECT_TRUE(says(warnings(load_described("sphere { 0, 1 pigment { mandel 9 exponent 34 } }")), "2 is taken"));
}

TEST(ParsePattern, SlopeTakesADirectionOrABlock) {
  const auto simple = parameters<render::SlopeParameters>(pigment_of("slope <0, 2, 0>").pattern);
  EXPECT_EQ(simple.direction, Vec3(0, 2, 0));
  const auto full = parameters<render::SlopeParameters>(pigment_of("slope { y, 0.5, 1 altitude x, -1, 2 }").pattern);
  EXPECT_EQ(full.low, 0.5);
  EXPECT_EQ(full.high, 1.0);
  EXPECT_EQ(full.altitude, Vec3(1, 0, 0));
  EXPECT_EQ(full.low_altitude, -1.0);
  EXPECT_EQ(full.high_altitude, 2.0);
  EXPECT_TRUE(parameters<render::SlopeParameters>(pigment_of("slope { point_at <1, 2, 3> }").pattern).to_point);
  EXPECT_TRUE(says(pigment_error("slope { point_at y altitude x }"), "'altitude' does not go with 'point_at'"));
  EXPECT_TRUE(says(pigment_error("slope 0"), "'slope' needs a direction"));
}

TEST(ParsePattern, PavementHasOnlySoManyPatterns) {
  const auto pavement = parameters<render::PavementParameters>(
      pigment_of("pavement number_of_sides 4 number_of_tiles 3 pattern 2 exterior 1 interior 2 form 3").pattern);
  EXPECT_EQ(pavement.sides, 4);
  EXPECT_EQ(pavement.tiles, 3);
  EXPECT_EQ(pavement.pattern, 2);
  EXPECT_EQ(pavement.exterior, 1);
  EXPECT_EQ(pavement.interior, 2);
  EXPECT_EQ(pavement.form, 3);
  EXPECT_TRUE(says(pigment_error("pavement number_of_sides 5"), "must be 3, 4 or 6"));
  EXPECT_TRUE(says(pigment_error("pavement number_of_sides 6 number_of_tiles 6"), "from 1 to 5"));
  EXPECT_TRUE(says(pigment_error("pavement pattern 2"), "from 1 to 1"));
}

TEST(ParsePattern, OtherParametersHaveTheirWords) {
  EXPECT_EQ(parameters<render::AgateParameters>(pigment_of("agate agate_turb 0.25").pattern).turbulence, 0.25);
  EXPECT_EQ(parameters<render::SpiralParameters>(pigment_of("spiral1 5").pattern).arms, 5);
  EXPECT_EQ(kind_of("spiral2 3"), PatternKind::spiral2);
  EXPECT_EQ(parameters<render::TilingParameters>(pigment_of("tiling 27").pattern).type, 27);
  EXPECT_TRUE(says(pigment_error("tiling 28"), "from 1 to 27"));
  const auto quilted = parameters<render::QuiltedParameters>(pigment_of("quilted control0 0.5 control1 2").pattern);
  EXPECT_EQ(quilted.control0, 0.5);
  EXPECT_EQ(quilted.control1, 2.0);
  EXPECT_TRUE(says(pigment_error("bozo control0 1"), "'control0' is for 'quilted' only"));
}

TEST(ParsePattern, SomePatternsBringTheirWave) {
  for (const char* words : {"marble", "wood", "spiral1 2", "spiral2 2"}) {
    EXPECT_EQ(pigment_of(words).pattern->wave.form, WaveForm::triangle) << words;
  }
  EXPECT_EQ(pigment_of("marble ramp_wave").pattern->wave.form, WaveForm::ramp);
  EXPECT_EQ(pigment_of("bozo sine_wave").pattern->wave.form, WaveForm::sine);
  EXPECT_EQ(pigment_of("bozo scallop_wave").pattern->wave.form, WaveForm::scallop);
  EXPECT_EQ(pigment_of("bozo cubic_wave").pattern->wave.form, WaveForm::cubic);
  EXPECT_EQ(pigment_of("bozo triangle_wave").pattern->wave.form, WaveForm::triangle);
  EXPECT_EQ(pigment_of("quilted").pattern->wave.frequency, 0.0);
  EXPECT_EQ(pigment_of("hexagon").pattern->wave.frequency, 0.0);
  EXPECT_EQ(pigment_of("bozo").pattern->wave.frequency, 1.0);
}

TEST(ParsePattern, TurbulenceStandsNearestToThePattern) {
  const auto warps =
      pigment_of("bozo translate x turbulence <1, 2, 3> octaves 20 lambda 3 omega 0.25 scale 2").pattern->warps;
  ASSERT_TRUE(warps.turbulence);
  EXPECT_EQ(warps.turbulence->amount, Vec3(1, 2, 3));
  EXPECT_EQ(warps.turbulence->octaves, 10);
  EXPECT_EQ(warps.turbulence->lambda, 3.0);
  EXPECT_EQ(warps.turbulence->omega, 0.25);
  ASSERT_EQ(warps.steps.size(), 1u);
  const Vec3 still(1, 0, 0);
  expect_near(warps.to_pattern(Vec3(4, 0, 0), false), still);
  const Vec3 moved = still + render::dturbulence(still, render::octaves_of(*warps.turbulence)) * Vec3(1, 2, 3);
  expect_near(warps.to_pattern(Vec3(4, 0, 0)), moved);
}

TEST(ParsePattern, WarpsAndTransformationsKeepTheirOrder) {
  const auto steps = pigment_of(
                         "bozo scale 2 translate x warp { turbulence 0.5 octaves 2 omega 0.1 lambda 4 } rotate 90*z "
                         "warp { cubic } warp { planar y, 3 }")
                         .pattern->warps.steps;
  ASSERT_EQ(steps.size(), 5u);
  EXPECT_TRUE(std::holds_alternative<render::Transform>(steps[0]));
  EXPECT_EQ(std::get<render::Turbulence>(steps[1]).octaves, 2);
  EXPECT_TRUE(std::holds_alternative<render::Transform>(steps[2]));
  EXPECT_TRUE(std::holds_alternative<render::CubicWarp>(steps[3]));
  EXPECT_EQ(std::get<render::PlanarWarp>(steps[4]).orientation, Vec3(0, 1, 0));
  EXPECT_EQ(std::get<render::PlanarWarp>(steps[4]).offset, 3.0);
}

TEST(ParsePattern, EachWarpHasItsWords) {
  const auto warp_of = [](std::string words) {
    const auto steps = pigment_of("bozo warp { " + words + " }").pattern->warps.steps;
    EXPECT_EQ(steps.size(), 1u);
    return steps.empty() ? render::Warp() : steps.front();
  };
  const auto repeat = std::get<render::RepeatWarp>(warp_of("repeat 2*y offset <1, 0, 0> flip x"));
  EXPECT_EQ(repeat.axis, 1);
  EXPECT_EQ(repeat.width, 2.0);
  EXPECT_EQ(repeat.offset, Vec3(1, 0, 0));
  EXPECT_EQ(repeat.flip, Vec3(-1, 1, 1));
  const auto hole = std::get<render::BlackHoleWarp>(
      warp_of("black_hole <3, 3, 3>, 2 strength 1.5 falloff 3 inverse type 1 repeat <9, 0, 0> turbulence 0.5"));
  EXPECT_EQ(hole.center, Vec3(3, 3, 3));
  EXPECT_EQ(hole.radius, 2.0);
  EXPECT_EQ(hole.strength, 1.5);
  EXPECT_EQ(hole.falloff, 3.0);
  EXPECT_TRUE(hole.inverted);
  EXPECT_EQ(hole.type, 1);
  EXPECT_EQ(hole.repeat, Vec3(9, 0, 0));
  EXPECT_EQ(hole.turbulence, Vec3(0.5));
  const auto cylinder = std::get<render::CylindricalWarp>(warp_of("cylindrical orientation 2*y dist_exp 1"));
  EXPECT_EQ(cylinder.orientation, Vec3(0, 1, 0));
  EXPECT_EQ(cylinder.distance_exponent, 1.0);
  EXPECT_EQ(std::get<render::SphericalWarp>(warp_of("spherical")).orientation, Vec3(0, 0, 1));
  EXPECT_EQ(std::get<render::ToroidalWarp>(warp_of("toroidal major_radius 3")).major_radius, 3.0);
  EXPECT_TRUE(says(pigment_error("bozo warp { repeat <1, 1, 0> }"), "along one axis"));
  EXPECT_TRUE(says(pigment_error("bozo warp { }"), "expected a kind of warp, found '}'"));
}

TEST(ParsePattern, BlackHolesAreMovedIntoTheirBlock) {
  const auto result = load_described("sphere { 0, 1 pigment { bozo warp { black_hole 0, 2 repeat 3*x } } }");
  ASSERT_TRUE(result.scene);
  EXPECT_TRUE(says(warnings(result), "too small along x"));
  const auto& hole = std::get<render::BlackHoleWarp>(layer_of(*result.scene).pigment.pattern->warps.steps.at(0));
  EXPECT_EQ(hole.center.x, 2.0);
  EXPECT_EQ(hole.repeat->x, 4.0);
}

TEST(ParsePattern, ObjectPatternHoldsTheObject) {
  const auto pigment = pigment_of("object { sphere { 0, 2 } rgb 1, rgb x }");
  const auto& object = parameters<render::ObjectParameters>(pigment.pattern).object;
  ASSERT_TRUE(object);
  EXPECT_EQ(object->word, "sphere");
  EXPECT_EQ(pigment.pattern->map.at(0).color.rgb, render::Rgb(1));
  EXPECT_EQ(pigment.pattern->map.at(1).color.rgb, render::Rgb(1, 0, 0));
  EXPECT_TRUE(says(pigment_error("object { rgb 1 }"), "expected an object"));
}

TEST(ParsePattern, PigmentPatternHoldsThePigment) {
  const auto pigment = pigment_of("pigment_pattern { granite scale 2 } color_map { [0 rgb 0] [1 rgb x] }");
  const auto& inner = parameters<render::PigmentParameters>(pigment.pattern).pigment;
  ASSERT_TRUE(inner);
  EXPECT_EQ(inner->pattern->kind, PatternKind::granite);
}

TEST(ParsePattern, FunctionPatternHoldsTheFunction) {
  const auto pigment = pigment_of("function { x * 2 + y } color_map { [0 rgb 0] [1 rgb 1] }");
  const auto& function = parameters<render::FunctionParameters>(pigment.pattern).function;
  ASSERT_TRUE(function);
  const double point[3] = {1.5, 0.25, 0.0};
  double value = 0.0;
  render::Evaluation evaluation;
  function->evaluate(point, &value, evaluation);
  EXPECT_EQ(value, 3.25);
  EXPECT_NE(pigment_error("function { }"), "");
}

TEST(ParsePattern, NoiseGeneratorIsFromZeroToThree) {
  EXPECT_EQ(pigment_of("bozo noise_generator 2").pattern->noise_generator, 2);
  EXPECT_EQ(pigment_of("bozo").pattern->noise_generator, 0);
  EXPECT_TRUE(says(pigment_error("bozo noise_generator 4"), "must be 0, 1, 2 or 3"));
}

TEST(ParsePattern, WordsOfOtherPlacesAreRefused) {
  EXPECT_TRUE(says(pigment_error("facets"), "'facets' is for 'normal' only"));
  EXPECT_TRUE(says(pigment_error("bump_map { png \"a.png\" }"), "'bump_map' is for 'normal' only"));
  EXPECT_TRUE(says(pigment_error("average"), "'average' needs a map"));
  EXPECT_TRUE(says(errors(load_described("sphere { 0, 1 normal { rgb 1 } }")), "a colour is for 'pigment'"));
  EXPECT_TRUE(says(errors(load_described("sphere { 0, 1 normal { image_map { png \"a\" } } }")), "for 'pigment' only"));
}

TEST(ParsePattern, DescriptionsAreNestedSoDeepAndNoDeeper) {
  const auto nested = [](std::string levels) {
    return "#declare P = pigment { bozo } #for (I, 1, " + levels +
           ") #declare P = pigment { bozo pigment_map { [0 P] [1 P] } } #end sphere { 0, 1 pigment { P } }";
  };
  EXPECT_EQ(errors(load_described(nested("100"))), "");
  EXPECT_TRUE(says(errors(load_described(nested("1000"))), "nested more than 400 deep"));
  std::string uv = "sphere { 0, 1 pigment { ";
  for (int i = 0; i < 100000; ++i) uv += "uv_mapping ";
  EXPECT_NE(errors(load_described(uv + "bozo } }")), "");
}

}  // namespace
}  // namespace firstlight::parser
