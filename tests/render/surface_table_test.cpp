#include "render/surface/surface_table.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace firstlight::render {
namespace {

TextureLayer layer_of(const FilteredColor& color, const Finish& finish = {}) {
  TextureLayer layer;
  layer.pigment.color = color;
  layer.finish = finish;
  return layer;
}

Scene scene_of(const std::vector<std::vector<TextureLayer>>& textures) {
  Scene scene;
  for (const std::vector<TextureLayer>& layers : textures) {
    scene.textures.push_back({std::make_shared<Texture>(Texture{layers}), Transform()});
  }
  return scene;
}

constexpr float kThird = 1.0f / 3.0f;

TEST(SurfaceTable, HoldsTheLayersOfEachTextureInOrder) {
  const Scene scene = scene_of({{layer_of({Rgb(0.1f)})}, {}, {layer_of({Rgb(0.2f)}), layer_of({Rgb(0.3f)})}});
  const SurfaceTable table(scene);
  ASSERT_EQ(table.layers(*table.even_coat(0)).size(), 1u);
  EXPECT_TRUE(table.layers(*table.even_coat(1)).empty());
  ASSERT_EQ(table.layers(*table.even_coat(2)).size(), 2u);
  EXPECT_EQ(table.layers(*table.even_coat(0))[0].color.rgb, Rgb(0.1f));
  EXPECT_EQ(table.layers(*table.even_coat(2))[0].color.rgb, Rgb(0.2f));
  EXPECT_EQ(table.layers(*table.even_coat(2))[1].color.rgb, Rgb(0.3f));
  EXPECT_EQ(table.layers(*table.even_coat(2))[1].source, &scene.textures[2].texture->layers[1]);
}

TEST(SurfaceTable, OwnLightIsAmbientInTheScenesAmbientLightAndEmission) {
  Finish finish;
  finish.ambient = Rgb(0.5f);
  finish.emission = Rgb(0.25f);
  Scene scene = scene_of({{layer_of({Rgb(0.5f), 0.0f, 0.5f}, finish)}});
  scene.settings.ambient_light = Rgb(2.0f, 1.0f, 0.0f);
  const SurfaceTable table(scene);
  // Half of it is clear: 0.5 * (0.5 * ambient_light + 0.25) * 0.5.
  EXPECT_EQ(table.layers(*table.even_coat(0))[0].color.own_light, Rgb(0.3125f, 0.1875f, 0.0625f));
  EXPECT_EQ(table.layers(*table.even_coat(0))[0].color.passed, Rgb(0.5f));
}

TEST(SurfaceTable, BeforeVersion37FilteredColorsAreMoreOpaque) {
  Scene scene = scene_of({{layer_of({Rgb(0.5f, 0.25f, 0.0f), 0.5f, 0.25f})}});
  const auto opacity = [&scene] {
    const SurfaceTable table(scene);
    return table.layers(*table.even_coat(0))[0].color.opacity;
  };
  EXPECT_DOUBLE_EQ(opacity(), 0.25);
  scene.settings.language_version = 360;
  EXPECT_DOUBLE_EQ(opacity(), 0.5);  // 1 - (0.5 * 0.5 + 0.25)
}

TEST(SurfaceTable, AMirrorIsEvenWhenItReflectsAlikeFromAllAngles) {
  Finish none;
  Finish even;
  even.reflection_min = even.reflection_max = Rgb(kThird);
  Finish grazing = even;
  grazing.reflection_min = Rgb(0.0f);
  Finish fresnel = even;
  fresnel.reflection_fresnel = true;
  Finish metallic = even;
  metallic.reflection_metallic = 1.0;
  std::vector<TextureLayer> layers;
  for (const Finish& finish : {none, even, grazing, fresnel, metallic}) layers.push_back(layer_of({Rgb(1.0f)}, finish));
  const Scene scene = scene_of({layers});
  const SurfaceTable table(scene);
  const std::vector<bool> reflects{false, true, true, true, true};
  const std::vector<bool> is_even{true, true, false, false, false};
  for (std::size_t i = 0; i < layers.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(table.layers(*table.even_coat(0))[i].reflects, reflects[i]);
    EXPECT_EQ(table.layers(*table.even_coat(0))[i].is_even_mirror, is_even[i]);
  }
  EXPECT_EQ(table.layers(*table.even_coat(0))[1].reflection, Rgb(kThird));
  EXPECT_EQ(table.layers(*table.even_coat(0))[2].strongest, kThird);
}

TEST(SurfaceTable, NegativeDiffuseIsNone) {
  Finish finish;
  finish.diffuse = -1.0;
  finish.diffuse_back = -0.5;
  const Scene scene = scene_of({{layer_of({Rgb(1.0f)}, finish)}});
  const SurfaceTable table(scene);
  EXPECT_EQ(table.layers(*table.even_coat(0))[0].diffuse, 0.0);
  EXPECT_EQ(table.layers(*table.even_coat(0))[0].diffuse_back, 0.0);
}

SurfacePoints points_at(std::initializer_list<Vec3> places) {
  SurfacePoints points;
  points.on_surface = true;
  for (const Vec3& place : places) {
    const std::size_t i = points.size++;
    points.at.set(i, place);
    points.normal.set(i, Vec3(0.0, 1.0, 0.0));
    points.tilted.set(i, Vec3(0.0, 1.0, 0.0));
    points.direction.set(i, Vec3(0.0, -1.0, 0.0));
    points.uv.set(i, Vec2(0.0));
  }
  return points;
}

TEST(SurfaceTable, WhatHasAPatternIsNotEven) {
  TextureLayer layer = layer_of({Rgb(1.0f)});
  layer.pigment.pattern = PigmentPattern{patterned(PatternKind::checker)};
  const Scene scene = scene_of({{layer}});
  const SurfaceTable table(scene);
  EXPECT_EQ(table.even_coat(0), nullptr);
  CoatList coats;
  table.unfold(0, points_at({{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}}), coats);
  ASSERT_EQ(coats.size(), 1u);
  const SurfaceLayer& found = table.layers(*coats[0].coat)[0];
  EXPECT_FALSE(found.is_plain);
  LayerLook look;
  table.look(found, coats[0], look);
  EXPECT_EQ(look.colors.color(0).rgb, Rgb(0.0f, 0.0f, 1.0f));
  EXPECT_EQ(look.colors.color(1).rgb, Rgb(0.0f, 1.0f, 0.0f));
  EXPECT_EQ(table.color(found, {Rgb(0.5f), 1.0f, 0.0f}).passed, Rgb(0.5f));
}

/// From red glass at x = 0 to clear glass at x = 1.
Scene scene_of_a_map() {
  const auto red = std::make_shared<Texture>(Texture{{layer_of({Rgb(1.0f, 0.0f, 0.0f), 1.0f, 0.0f})}});
  const auto clear = std::make_shared<Texture>(Texture{{layer_of({Rgb(0.0f), 0.0f, 1.0f})}});
  TexturePattern map;
  map.pattern = patterned(PatternKind::gradient, GradientParameters{{1.0, 0.0, 0.0}});
  map.textures = std::make_shared<TextureMap>(TextureMap{{{0.0, red}, {1.0, clear}}});
  TextureLayer layer;
  layer.extras.change().patterned = std::make_shared<TexturePattern>(map);
  return scene_of({{layer}});
}

TEST(SurfaceTable, AMapShowsBothOfItsNeighbouringTexturesByTheirShares) {
  const Scene scene = scene_of_a_map();
  const SurfaceTable table(scene);
  CoatList coats;
  table.unfold(0, points_at({{0.0, 0.0, 0.0}, {0.25, 0.0, 0.0}, {1.0, 0.0, 0.0}}), coats);
  ASSERT_EQ(coats.size(), 2u);
  ASSERT_EQ(coats[0].points.size, 2u);
  EXPECT_EQ(coats[0].lane[0], 0);
  EXPECT_EQ(coats[0].lane[1], 1);
  EXPECT_DOUBLE_EQ(coats[0].share[0], 1.0);
  EXPECT_DOUBLE_EQ(coats[0].share[1], 0.75);
  ASSERT_EQ(coats[1].points.size, 2u);
  EXPECT_EQ(coats[1].lane[0], 1);
  EXPECT_DOUBLE_EQ(coats[1].share[0], 0.25);
  EXPECT_DOUBLE_EQ(coats[1].share[1], 1.0);
}

TEST(SurfaceTable, LightThroughAMapIsFilteredByBothTextures) {
  const Scene scene = scene_of_a_map();
  const SurfaceTable table(scene);
  std::vector<Rgb> light(2, Rgb(0.5f));
  CoatList scratch;
  table.filter(0, points_at({{0.0, 0.0, 0.0}, {0.25, 0.0, 0.0}}), light, scratch);
  EXPECT_EQ(light[0], Rgb(0.5f, 0.0f, 0.0f));
  EXPECT_EQ(light[1], Rgb(0.5f, 0.125f, 0.125f));
}

TEST(SurfaceTable, ATiltedNormalIsLeftWithThePoints) {
  TextureLayer layer = layer_of({Rgb(1.0f)});
  auto normal = std::make_shared<Normal>();
  normal->pattern = patterned(PatternKind::bumps);
  layer.extras.change().normal = std::move(normal);
  const Scene scene = scene_of({{layer}});
  const SurfaceTable table(scene);
  CoatList coats;
  table.unfold(0, points_at({{0.3, 0.4, 0.5}}), coats);
  ASSERT_EQ(coats.size(), 1u);
  LayerLook look;
  table.look(table.layers(*coats[0].coat)[0], coats[0], look);
  const Vec3 tilted = look.normals.vector(0);
  EXPECT_NEAR(tilted.length(), 1.0, 1e-12);
  EXPECT_NE(tilted, Vec3(0.0, 1.0, 0.0));
  EXPECT_EQ(coats[0].points.tilted.vector(0), tilted);
}

}  // namespace
}  // namespace firstlight::render
