#pragma once

#include "render/scene/scene.h"
#include "render/shape/shape.h"
#include "render/trace/shape_runs.h"

#include <bit>
#include <cstdint>
#include <vector>

namespace firstlight::render {

/// Whether a surface, seen from a side, shows textures of its shape's list; else it shows only_texture().
inline bool shows_own_textures(const Part& part, bool from_inside) {
  return part.has_shape_textures && !(from_inside && part.interior_texture != kNoIndex);
}

/// Index into Scene::textures, or kNoIndex. Pre: not shows_own_textures().
inline std::uint32_t only_texture(const Part& part, bool from_inside) {
  return from_inside && part.interior_texture != kNoIndex ? part.interior_texture : part.texture;
}

/// The same of parts that have no texture and show what they cut.
template <class Visit>
void for_each_cut_texture(const Scene& scene, const SurfacePlaces& places, std::uint64_t which,
                          std::vector<TextureShare>& scratch, const Visit& visit) {
  if (scene.cutaways.empty()) return;
  for (; which != 0; which &= which - 1) {
    const auto place = static_cast<std::uint32_t>(std::countr_zero(which));
    const Part& part = scene.parts[places.crossing[place]->part];
    if (part.cutaway == kNoIndex) continue;
    scratch.clear();
    add_cut_textures(scene, part.cutaway, places.point.vector(place), place, scratch);
    for (const TextureShare& share : scratch) {
      if (share.weight >= scene.settings.adc_bailout) visit(place, share.texture, share.weight);
    }
  }
}

/// Calls visit(place, index into Scene::textures, share) for the textures that are seen at the places whose bits are
/// set, place by place. `scratch`: what it holds is lost. Pre: shows_own_textures().
template <class Visit>
void for_each_own_texture(const Scene& scene, const SurfacePlaces& places, std::uint64_t which,
                          std::vector<TextureShare>& scratch, const Visit& visit) {
  for_each_run(places, which, [&](const Shape& shape, std::size_t first, std::size_t end) {
    scratch.clear();
    shape.textures(places, first, end, scratch);
    for (const TextureShare& share : scratch) {
      const Part& part = scene.parts[places.crossing[share.place]->part];
      const std::uint32_t texture =
          share.texture == kObjectTexture ? part.texture : scene.shape_textures[part.shape_textures + share.texture];
      if (texture == kNoIndex || share.weight < scene.settings.adc_bailout) continue;
      visit(share.place, texture, share.weight);
    }
  });
  for_each_cut_texture(scene, places, which, scratch, visit);
}

}  // namespace firstlight::render
