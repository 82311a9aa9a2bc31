#pragma once

#include "render/texture/finish.h"
#include "render/texture/pigment.h"

#include <memory>
#include <vector>

namespace firstlight::render {

struct TextureLayer {
  Pigment pigment;
  Finish finish;
  FeatureUses unrendered = {};  ///< beyond those of pigment and finish
};

/// What covers a surface, in layers. Shared between objects, immutable once shared; each use has its own placement.
struct Texture {
  std::vector<TextureLayer> layers;  ///< topmost first, as they are shaded
};

using TexturePtr = std::shared_ptr<const Texture>;

/// Whether no light at all passes through the texture.
bool is_opaque(const Texture& texture);

}  // namespace firstlight::render
