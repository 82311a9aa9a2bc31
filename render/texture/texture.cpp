#include "render/texture/texture.h"

#include <algorithm>

namespace firstlight::render {

bool is_opaque(const Texture& texture) {
  // One opaque layer hides all below it and lets nothing out from above.
  return std::any_of(texture.layers.begin(), texture.layers.end(),
                     [](const TextureLayer& layer) { return !lets_light_through(layer.pigment); });
}

}  // namespace firstlight::render
