#include "render/texture/texture.h"

#include <algorithm>

namespace firstlight::render {

bool is_opaque(const Texture& texture) {
  // One opaque layer hides all below it and lets nothing out from above.
  return std::any_of(texture.layers.begin(), texture.layers.end(), [](const TextureLayer& layer) {
    if (!layer.extras->patterned) return !lets_light_through(layer.pigment);
    const TexturePattern& pattern = *layer.extras->patterned;
    const auto* const laid = std::get_if<ImageParameters>(&pattern.pattern.parameters);
    return !pattern.textures->translucent && !(laid != nullptr && laid->image && laid->image->once);
  });
}

bool is_plain(const Texture& texture) {
  return std::none_of(texture.layers.begin(), texture.layers.end(), [](const TextureLayer& layer) {
    return layer.extras->patterned || layer.extras->normal || is_patterned(layer.pigment.pattern->kind);
  });
}

std::uint32_t depth_of(const Texture& texture) {
  std::uint32_t depth = 0;
  for (const TextureLayer& layer : texture.layers) {
    depth = std::max(depth, layer.pigment.pattern->depth);
    if (layer.extras->normal) depth = std::max(depth, layer.extras->normal->pattern.depth);
    if (layer.extras->patterned) depth = std::max(depth, layer.extras->patterned->pattern.depth);
  }
  return depth;
}

TexturePtr moved(const TexturePtr& texture, const Transform& transform) {
  if (!texture || transform.is_identity()) return texture;
  auto result = std::make_shared<Texture>(*texture);
  for (TextureLayer& layer : result->layers) {
    if (layer.extras->patterned) {
      auto pattern = std::make_shared<TexturePattern>(*layer.extras->patterned);
      pattern->pattern.warps.transform(transform);
      layer.extras.change().patterned = std::move(pattern);
      continue;
    }
    layer.pigment.pattern.change().warps.transform(transform);
    if (!layer.extras->normal) continue;
    auto normal = std::make_shared<Normal>(*layer.extras->normal);
    normal->pattern.warps.transform(transform);
    layer.extras.change().normal = std::move(normal);
  }
  return result;
}

void gather(const Texture& texture, FeatureUses& uses) {
  for (const TextureLayer& layer : texture.layers) {
    if (layer.extras->patterned) {
      gather(layer.extras->patterned->pattern, uses);
      uses.add(layer.extras->patterned->textures->unrendered);
      continue;
    }
    gather(layer.pigment, uses);
    if (layer.extras->normal) gather(*layer.extras->normal, uses);
    gather(*layer.finish, uses);
  }
}

}  // namespace firstlight::render
