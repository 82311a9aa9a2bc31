#pragma once

#include "render/scene/scene.h"
#include "render/shape/shape.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// Calls visit(index into Scene::textures, share) for the textures that are seen at a crossing: one for most, several of a
/// shape that has its own. `scratch`: for those; what it holds is lost.
template <class Visit>
void for_each_texture(const Scene& scene, const Vec3& point, const Crossing& crossing, bool from_inside,
                      std::vector<TextureShare>& scratch, const Visit& visit) {
  const Part& part = scene.parts[crossing.part];
  if (from_inside && part.interior_texture != kNoIndex) return visit(part.interior_texture, 1.0);
  if (!part.has_shape_textures) {
    if (part.texture != kNoIndex) visit(part.texture, 1.0);
    return;
  }
  scratch.clear();
  crossing.shape->textures(point, crossing, scratch);
  for (const TextureShare& share : scratch) {
    const std::uint32_t texture =
        share.texture == kObjectTexture ? part.texture : scene.shape_textures[part.shape_textures + share.texture];
    if (texture != kNoIndex && !(share.weight < scene.settings.adc_bailout)) visit(texture, share.weight);
  }
}

}  // namespace firstlight::render
