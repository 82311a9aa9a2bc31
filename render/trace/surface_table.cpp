#include "render/trace/surface_table.h"

#include <algorithm>

namespace firstlight::render {
namespace {

double positive(double amount) { return amount > 0.0 ? amount : 0.0; }

}  // namespace

SurfaceTable::SurfaceTable(const Scene& scene)
    : old_opacity_(scene.settings.language_version < 370), ambient_light_(scene.settings.ambient_light) {
  first_.reserve(scene.textures.size() + 1);
  layers_.reserve(scene.textures.size());
  first_.push_back(0);
  for (const PlacedTexture& placed : scene.textures) {
    for (const TextureLayer& layer : placed.texture->layers) layers_.push_back(prepared(layer));
    first_.push_back(layers_.size());
    glossy_.push_back(static_cast<std::uint8_t>(
        std::any_of(layers_.end() - static_cast<std::ptrdiff_t>(placed.texture->layers.size()), layers_.end(),
                    [](const SurfaceLayer& layer) { return layer.specular > 0.0 || layer.phong > 0.0; })));
  }
}

SurfaceLayer SurfaceTable::prepared(const TextureLayer& layer) const {
  const Finish& finish = *layer.finish;
  SurfaceLayer surface;
  surface.source = &layer;
  surface.own_light = finish.ambient * ambient_light_ + finish.emission;
  surface.diffuse = positive(finish.diffuse);
  surface.diffuse_back = positive(finish.diffuse_back);
  surface.brilliance = finish.brilliance;
  surface.phong = finish.phong;
  surface.phong_size = finish.phong_size;
  surface.specular = finish.specular;
  surface.specular_exponent = finish.roughness_exponent;
  surface.metallic = finish.metallic;
  surface.has_rare = surface.diffuse_back != 0.0 || surface.brilliance != 1.0 || surface.phong != 0.0 ||
                     (surface.metallic > 0.0 && surface.specular != 0.0);

  surface.reflects = !is_black(finish.reflection_max) || !is_black(finish.reflection_min);
  surface.strongest = std::max(max_component(finish.reflection_max), max_component(finish.reflection_min));
  surface.is_even_mirror = !surface.reflects || (finish.reflection_max == finish.reflection_min &&
                                                 !finish.reflection_fresnel && finish.reflection_metallic == 0.0);
  if (surface.is_even_mirror) surface.reflection = finish.reflection_max;

  surface.is_plain = !layer.pigment.pattern->field;
  if (surface.is_plain) surface.color = color(surface, layer.pigment.color);
  return surface;
}

LayerColor SurfaceTable::color(const SurfaceLayer& layer, const FilteredColor& pigment) const {
  LayerColor color;
  color.rgb = pigment.rgb;
  color.passed = pigment.passed();
  // Before 3.7 a tinted layer kept more of its own light. [POV-Ray 3.7: language version below 370]
  color.opacity = old_opacity_ ? 1.0 - (pigment.filter * max_component(pigment.rgb) + pigment.transmit)
                               : 1.0 - pigment.filter - pigment.transmit;
  color.own_light = pigment.rgb * layer.own_light * static_cast<float>(color.opacity);
  return color;
}

}  // namespace firstlight::render
