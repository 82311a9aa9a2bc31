#include "render/trace/surface_table.h"

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
  ASSERT_EQ(table.layers(0).size(), 1u);
  EXPECT_TRUE(table.layers(1).empty());
  ASSERT_EQ(table.layers(2).size(), 2u);
  EXPECT_EQ(table.layers(0)[0].color.rgb, Rgb(0.1f));
  EXPECT_EQ(table.layers(2)[0].color.rgb, Rgb(0.2f));
  EXPECT_EQ(table.layers(2)[1].color.rgb, Rgb(0.3f));
  EXPECT_EQ(table.layers(2)[1].source, &scene.textures[2].texture->layers[1]);
}

TEST(SurfaceTable, OwnLightIsAmbientInTheScenesAmbientLightAndEmission) {
  Finish finish;
  finish.ambient = Rgb(0.5f);
  finish.emission = Rgb(0.25f);
  Scene scene = scene_of({{layer_of({Rgb(0.5f), 0.0f, 0.5f}, finish)}});
  scene.settings.ambient_light = Rgb(2.0f, 1.0f, 0.0f);
  const SurfaceTable table(scene);
  // Half of it is clear: 0.5 * (0.5 * ambient_light + 0.25) * 0.5.
  EXPECT_EQ(table.layers(0)[0].color.own_light, Rgb(0.3125f, 0.1875f, 0.0625f));
  EXPECT_EQ(table.layers(0)[0].color.passed, Rgb(0.5f));
}

TEST(SurfaceTable, BeforeVersion37FilteredColorsAreMoreOpaque) {
  Scene scene = scene_of({{layer_of({Rgb(0.5f, 0.25f, 0.0f), 0.5f, 0.25f})}});
  EXPECT_DOUBLE_EQ(SurfaceTable(scene).layers(0)[0].color.opacity, 0.25);
  scene.settings.language_version = 360;
  EXPECT_DOUBLE_EQ(SurfaceTable(scene).layers(0)[0].color.opacity, 0.5);  // 1 - (0.5 * 0.5 + 0.25)
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
    EXPECT_EQ(table.layers(0)[i].reflects, reflects[i]);
    EXPECT_EQ(table.layers(0)[i].is_even_mirror, is_even[i]);
  }
  EXPECT_EQ(table.layers(0)[1].reflection, Rgb(kThird));
  EXPECT_EQ(table.layers(0)[2].strongest, kThird);
}

TEST(SurfaceTable, NegativeDiffuseIsNone) {
  Finish finish;
  finish.diffuse = -1.0;
  finish.diffuse_back = -0.5;
  const Scene scene = scene_of({{layer_of({Rgb(1.0f)}, finish)}});
  const SurfaceTable table(scene);
  EXPECT_EQ(table.layers(0)[0].diffuse, 0.0);
  EXPECT_EQ(table.layers(0)[0].diffuse_back, 0.0);
}

TEST(SurfaceTable, WhatHasAPatternIsNotPlain) {
  TextureLayer layer = layer_of({Rgb(1.0f)});
  layer.pigment.pattern = PigmentPattern{patterned(PatternKind::checker)};
  const Scene scene = scene_of({{layer}});
  const SurfaceTable table(scene);
  EXPECT_FALSE(table.layers(0)[0].is_plain);
  EXPECT_EQ(table.color(table.layers(0)[0], {Rgb(0.5f), 1.0f, 0.0f}).passed, Rgb(0.5f));
}

}  // namespace
}  // namespace firstlight::render
