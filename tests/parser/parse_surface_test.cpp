#include "tests/parser/surface_text.h"

namespace firstlight::parser {
namespace {

using render::Media;
using render::PatternKind;
using render::Rgb;
using render::Vec3;

TEST(ParseNormal, HasPatternAmountAndAccuracy) {
  const auto bare = normal_of("bumps");
  EXPECT_EQ(bare.pattern.kind, PatternKind::bumps);
  EXPECT_EQ(bare.amount, 0.5);
  EXPECT_EQ(bare.accuracy, 0.02);
  const auto full = normal_of("dents, 0.7 accuracy 0.1 scale 2 no_bump_scale");
  EXPECT_EQ(full.amount, 0.7);
  EXPECT_EQ(full.accuracy, 0.1);
  EXPECT_TRUE(full.pattern.keeps_bump_size);
  EXPECT_EQ(normal_of("wrinkles 0.2 bump_size 0.9").amount, 0.9);
  EXPECT_EQ(unrendered("sphere { 0, 1 normal { pavement 0.2 } }"), "pavement ");
}

TEST(ParseNormal, FacetsHaveSizeCoordsAndMetric) {
  const auto facets = parameters<render::FacetsParameters>(normal_of("facets size 0.5 coords 2 metric 1").pattern);
  EXPECT_EQ(facets.size, 0.5);
  EXPECT_EQ(facets.coords, 2.0);
  EXPECT_EQ(facets.metric, 1.0);
}

TEST(ParseNormal, ListsOfNormalsMayBeLeftOut) {
  EXPECT_FALSE(normal_of("checker 0.3").normals);
  const auto brick = normal_of("brick normal { bumps 1 }, normal { dents 2 } brick_size 2");
  ASSERT_TRUE(brick.normals);
  EXPECT_EQ(brick.accuracy, 0.02);
  EXPECT_EQ(brick.normals->entries.at(1).value.amount, 2.0);
}

TEST(ParseNormal, BlocksAlterWhatIsThere) {
  const auto scene = surface_scene(
      "#declare N = normal { bumps 0.3 scale 2 } #default { normal { wrinkles 0.4 } }"
      "sphere { 0, 1 normal { N bump_size 1 } } sphere { 0, 1 texture { N } } sphere { 0, 1 normal { frequency 2 } }"
      "sphere { 0, 1 pigment { rgb 1 } } sphere { 0, 1 texture { normal { N } translate x normal { phase 1 } } }");
  EXPECT_EQ(layer_of(*scene, 0).extras->normal->amount, 1.0);
  EXPECT_EQ(layer_of(*scene, 0).extras->normal->pattern.kind, PatternKind::bumps);
  EXPECT_EQ(layer_of(*scene, 1).extras->normal->amount, 0.3);
  EXPECT_EQ(layer_of(*scene, 2).extras->normal->pattern.kind, PatternKind::wrinkles);
  EXPECT_EQ(layer_of(*scene, 2).extras->normal->pattern.wave.frequency, 2.0);
  EXPECT_EQ(layer_of(*scene, 3).extras->normal->amount, 0.4);
  expect_near(layer_of(*scene, 4).extras->normal->pattern.warps.to_pattern(Vec3(3, 0, 0)), Vec3(1, 0, 0));
}

TEST(ParseTexturePattern, TexturesAreMixedByMapsListsAndTiles) {
  const auto map = texture_pattern_of("marble texture_map { [0 pigment { rgb x }] [1 pigment { rgb y }] } scale 2");
  EXPECT_EQ(map.pattern.kind, PatternKind::marble);
  EXPECT_EQ(map.pattern.wave.form, render::WaveForm::triangle);
  EXPECT_EQ(map.textures->entries.size(), 2u);
  expect_near(map.pattern.warps.to_pattern(Vec3(2, 0, 0)), Vec3(1, 0, 0));
  const auto list = texture_pattern_of("checker texture { pigment { rgb x } }, texture { pigment { rgb y } }");
  EXPECT_EQ(list.textures->entries.at(1).value->layers[0].pigment.color.rgb, Rgb(0, 1, 0));
  const auto tiles = texture_pattern_of("tiles { texture { pigment { rgb x } } tile2 texture { pigment { rgb y } } }");
  EXPECT_EQ(tiles.pattern.kind, PatternKind::tiles);
  EXPECT_EQ(tiles.textures->entries.at(1).value->layers[0].pigment.color.rgb, Rgb(1, 0, 0));
  EXPECT_EQ(unrendered("sphere { 0, 1 texture { checker texture { pigment { pavement } } texture { } } }"), "pavement ");
}

TEST(ParseTexturePattern, MovesAsAWhole) {
  const auto scene = surface_scene(
      "#declare T = texture { bozo texture_map { [0 pigment { rgb x }] [1 pigment { rgb y }] } }"
      "sphere { 0, 1 texture { T translate x no_bump_scale } translate y }");
  const auto& pattern = layer_of(*scene).extras->patterned->pattern;
  EXPECT_TRUE(pattern.keeps_bump_size);
  expect_near(pattern.warps.to_pattern(Vec3(1, 0, 0)), Vec3(0, 0, 0));
}

TEST(ParseTexturePattern, StandsAlone) {
  const std::string mixed = "texture { bozo texture_map { [0 pigment { rgb x }] [1 pigment { rgb y }] } }";
  const auto error = [](const std::string& text) { return errors(load_described("sphere { 0, 1 " + text + " }")); };
  EXPECT_TRUE(says(error(mixed + " texture { pigment { rgb 1 } }"), "cannot lie over one that is made of textures"));
  EXPECT_TRUE(says(error("texture { pigment { rgb 1 } } " + mixed), "made of textures cannot lie over another"));
  EXPECT_TRUE(says(error(mixed + " pigment { rgb 1 }"), "cannot alter a texture that is made of textures"));
  EXPECT_TRUE(says(error("texture { bozo }"), "needs a 'texture_map'"));
  EXPECT_TRUE(says(error("texture { texture_map { [0 pigment { rgb 1 }] } }"), "needs a pattern before it"));
  EXPECT_TRUE(says(errors(load_described("#default { " + mixed + " }")), "default texture cannot be made of textures"));
  EXPECT_TRUE(says(error("texture { tiles { texture { } } }"), "expected 'tile2'"));
}

TEST(ParseFinish, HoldsWhatIsNotRendered) {
  const auto scene = surface_scene(
      "sphere { 0, 1 finish { crand 0.1 irid { 0.3 thickness 0.5 turbulence 0.2 } subsurface { translucency rgb <1, 2, "
      "3> anisotropy 0.5 } } }");
  const render::Finish& finish = layer_of(*scene).finish;
  EXPECT_EQ(finish.crand, 0.1);
  EXPECT_EQ(finish.irid, 0.3);
  EXPECT_EQ(finish.irid_thickness, 0.5);
  EXPECT_EQ(finish.irid_turbulence, 0.2);
  EXPECT_TRUE(finish.subsurface);
  EXPECT_EQ(finish.subsurface_translucency, Rgb(1, 2, 3));
  EXPECT_EQ(finish.subsurface_anisotropy, Rgb(0.5f));
  EXPECT_EQ(unrendered("sphere { 0, 1 finish { crand 0.1 irid { 0.3 } subsurface { } } }"), "subsurface ");
  EXPECT_EQ(unrendered("sphere { 0, 1 finish { crand 0 irid { 0 } } }"), "");
}

TEST(ParseFinish, OldCausticsGoToTheInterior) {
  const auto result = load_described("sphere { 0, 1 finish { caustics 0.5 } }");
  ASSERT_TRUE(result.scene);
  EXPECT_EQ(interior_of(*result.scene).caustics, 0.5 / 45.0);
  EXPECT_TRUE(says(warnings(result), "'caustics' belongs in 'interior'"));
}

TEST(ParseInterior, HoldsDispersionCausticsAndMedia) {
  const auto scene = surface_scene(
      "sphere { 0, 1 interior { ior 1.5 dispersion 1.02 dispersion_samples 9 caustics 0.7 media { } media { } } }");
  const render::Interior& interior = interior_of(*scene);
  EXPECT_EQ(interior.dispersion, 1.02);
  EXPECT_EQ(interior.dispersion_samples, 9);
  EXPECT_EQ(interior.caustics, 0.7);
  EXPECT_EQ(interior.media.size(), 2u);
  EXPECT_EQ(unrendered("sphere { 0, 1 interior { dispersion 1.02 caustics 1 media { } } }"),
            "media ");
  EXPECT_TRUE(says(errors(load_described("sphere { 0, 1 interior { dispersion 0 } }")), "above 0"));
  EXPECT_TRUE(says(errors(load_described("sphere { 0, 1 interior { dispersion_samples 1001 } }")), "at most 1000"));
  EXPECT_TRUE(says(errors(load_described("sphere { 0, 1 interior { dispersion_samples 1 } }")), "at least 2"));
}

Media media_of(std::string_view words) {
  const auto scene = surface_scene("sphere { 0, 1 interior { media { " + std::string(words) + " } } }");
  const render::Interior& interior = interior_of(*scene);
  EXPECT_EQ(interior.media.size(), 1u);
  return interior.media.front();
}

TEST(ParseMedia, DefaultsAreThoseOfVersion35AndLater) {
  const Media media = media_of("");
  EXPECT_EQ(media.method, 3);
  EXPECT_EQ(media.intervals, 1);
  EXPECT_EQ(media.least_samples, 10);
  EXPECT_EQ(media.most_samples, 10);
  EXPECT_EQ(media.confidence, 0.9);
  EXPECT_EQ(media.variance, 1.0 / 128.0);
  EXPECT_EQ(media.ratio, 0.9);
  EXPECT_EQ(media.aa_threshold, 0.1);
  EXPECT_EQ(media.aa_level, 3);
  EXPECT_EQ(media.jitter, 0.0);
  EXPECT_TRUE(media.collects_photons);
  const auto old = surface_scene("#version 3.1; sphere { 0, 1 interior { media { } } }");
  EXPECT_EQ(interior_of(*old).media.at(0).method, 1);
  EXPECT_EQ(interior_of(*old).media.at(0).intervals, 10);
  EXPECT_EQ(interior_of(*old).media.at(0).least_samples, 1);
}

TEST(ParseMedia, EachWordHasItsField) {
  const Media media = media_of(
      "method 2 intervals 4 samples 5, 6 confidence 0.5 variance 0.25 ratio 0.75 aa_threshold 0.5 aa_level 4 jitter "
      "0.125 collect off absorption rgb x emission rgb y scattering { 5, rgb z eccentricity 0.3 extinction 0.4 }");
  EXPECT_EQ(media.method, 2);
  EXPECT_EQ(media.intervals, 4);
  EXPECT_EQ(media.least_samples, 5);
  EXPECT_EQ(media.most_samples, 6);
  EXPECT_EQ(media.confidence, 0.5);
  EXPECT_EQ(media.variance, 0.25);
  EXPECT_EQ(media.ratio, 0.75);
  EXPECT_EQ(media.aa_threshold, 0.5);
  EXPECT_EQ(media.aa_level, 4);
  EXPECT_EQ(media.jitter, 0.125);
  EXPECT_FALSE(media.collects_photons);
  EXPECT_EQ(media.absorption, Rgb(1, 0, 0));
  EXPECT_EQ(media.emission, Rgb(0, 1, 0));
  EXPECT_EQ(media.scattering, Rgb(0, 0, 1));
  EXPECT_EQ(media.scattering_type, Media::Scattering::henyey_greenstein);
  EXPECT_EQ(media.eccentricity, 0.3);
  EXPECT_EQ(media.extinction, 0.4);
}

TEST(ParseMedia, DensitiesArePatternsOfTheirOwn) {
  const Media media = media_of(
      "density { spherical density_map { [0 rgb 0] [1 bozo color_map { [0 rgb 0] [1 rgb 1] }] } } density { rgb 2 }");
  ASSERT_EQ(media.densities.size(), 2u);
  EXPECT_EQ(media.densities[0].pattern.kind, PatternKind::spherical);
  ASSERT_TRUE(media.densities[0].densities);
  EXPECT_EQ(media.densities[0].densities->entries.at(1).value.pattern.kind, PatternKind::bozo);
  EXPECT_EQ(media.densities[1].color.rgb, Rgb(2));
  const auto scene = surface_scene(
      "#declare D = density { cylindrical } #declare E = density_map { [0 rgb 0] [1 rgb 1] } #declare M = media { "
      "emission 2 density { D } }"
      "sphere { 0, 1 interior { media { M density { wood density_map { E } } } } }");
  EXPECT_EQ(interior_of(*scene).media.at(0).densities.size(), 2u);
}

TEST(ParseMedia, MovesWithTheObject) {
  const auto scene = surface_scene(
      "union { sphere { 0, 1 interior { media { density { spherical } translate x } } translate y } sphere { 3, 1 } "
      "translate z }"
      "#declare M = material { texture { pigment { rgbt 1 } } interior { media { density { spherical } } } translate "
      "2*x }"
      "sphere { 0, 1 material { M } scale 2 }");
  const auto place = [&](std::size_t part) {
    return interior_of(*scene, part).media.at(0).densities.at(0).pattern.warps.to_pattern(Vec3(1, 1, 1));
  };
  expect_near(place(0), Vec3(0, 0, 0));
  expect_near(place(2), Vec3(-1.5, 0.5, 0.5));
}

TEST(ParseMedia, MistakesAreNamed) {
  const auto error = [](std::string words) {
    return errors(load_described("sphere { 0, 1 interior { media { " + words + " } } }"));
  };
  EXPECT_TRUE(says(error("intervals 0"), "'intervals' must be at least 1"));
  EXPECT_TRUE(says(error("samples 0"), "'samples' must be at least 1"));
  EXPECT_TRUE(says(error("samples 5, 4"), "must not be below the first"));
  EXPECT_TRUE(says(error("method 4"), "'method' must be 1, 2 or 3"));
  EXPECT_TRUE(says(error("confidence 1"), "below 1"));
  EXPECT_TRUE(says(error("aa_threshold 0"), "above 0"));
  EXPECT_TRUE(says(error("aa_level 0"), "at least 1"));
  EXPECT_TRUE(
      says(warnings(load_described("sphere { 0, 1 interior { media { scattering { 6, rgb 1 } } } }")), "from 1 to 5"));
  EXPECT_TRUE(says(error("scattering { 1, rgb 1 eccentricity 1 }"), "scattering of type 5 only"));
  EXPECT_TRUE(says(error("density { pigment_map { [0 rgb 1] } }"), "expected '}'"));
}

TEST(ParseOldTexture, HasItsWordsOutsideOfBlocks) {
  const auto old_texture = [](std::string words) {
    return load_described("#version 1.0; sphere { 0, 1 texture { " + words + " } }");
  };
  const auto result = old_texture(
      "agate turbulence 0.5 octaves 3 color_map { [0 1 color red 1 color green 1] } bumps 0.3 frequency 2 phase 0.5 "
      "ambient 0.2 phong 1 phong_size 20 metallic scale 2");
  EXPECT_EQ(errors(result), "");
  ASSERT_TRUE(result.scene);
  const render::TextureLayer& layer = layer_of(*result.scene);
  EXPECT_EQ(layer.pigment.pattern->kind, PatternKind::agate);
  EXPECT_EQ(layer.pigment.pattern->warps.turbulence->octaves, 3);
  EXPECT_EQ(layer.pigment.pattern->map.size(), 2u);
  EXPECT_EQ(layer.pigment.pattern->warps.steps.size(), 1u);
  ASSERT_TRUE(layer.extras->normal);
  EXPECT_EQ(layer.extras->normal->amount, 0.3);
  EXPECT_EQ(layer.extras->normal->pattern.wave.frequency, 2.0);
  EXPECT_EQ(layer.finish->ambient, Rgb(0.2f));
  EXPECT_EQ(layer.finish->phong_size, 20.0);
  EXPECT_EQ(layer.finish->metallic, 1.0);
  const auto plain = old_texture("0.05 color red 1 wood");
  ASSERT_TRUE(plain.scene);
  EXPECT_EQ(layer_of(*plain.scene).finish->crand, 0.05);
  EXPECT_EQ(layer_of(*plain.scene).pigment.pattern->wave.form, render::WaveForm::ramp);
  EXPECT_TRUE(says(warnings(plain), "taken as 'crand'"));
  EXPECT_NE(errors(load_described("#version 3.0; sphere { 0, 1 texture { bumps 0.3 color red 1 } }")), "");
}

}  // namespace
}  // namespace firstlight::parser
