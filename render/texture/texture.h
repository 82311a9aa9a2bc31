#pragma once

#include "render/math/mostly_one.h"
#include "render/math/shared.h"
#include "render/texture/finish.h"
#include "render/texture/normal.h"
#include "render/texture/pigment.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace firstlight::render {

struct Texture;
using TexturePtr = std::shared_ptr<const Texture>;
using TextureMap = BlendMap<TexturePtr>;

/// A layer made of whole textures: texture_map, a list of textures, tiles, material_map, uv_mapping.
struct TexturePattern {
  Patterning pattern;
  std::shared_ptr<const TextureMap> textures;  ///< of a material_map: by the pixel's number, in order
};

/// Attributes that few layers have.
struct LayerExtras {
  std::shared_ptr<const Normal> normal = {};  ///< null: even
  bool keeps_bump_size = false;               ///< no_bump_scale, for all normals in the layer
  /// When not null, the layer is made of this alone, and has no pigment, normal or finish of its own.
  std::shared_ptr<const TexturePattern> patterned = {};
};

struct TextureLayer {
  Pigment pigment;
  Shared<Finish> finish;
  Shared<LayerExtras> extras = {};
};

/// The cover of a surface, in layers. Shared between objects, immutable once shared; each use has its own placement.
struct Texture {
  MostlyOne<TextureLayer> layers;  ///< topmost first, as they are shaded
};

/// Whether no light at all passes through the texture.
bool is_opaque(const Texture& texture);
/// Whether it looks the same everywhere.
bool is_plain(const Texture& texture);
/// Levels of descriptions in its maps.
std::uint32_t depth_of(const Texture& texture);
/// Moves the texture on. Null stays null.
TexturePtr moved(const TexturePtr& texture, const Transform& transform);
/// Adds what the texture asks for that cannot be rendered.
void gather(const Texture& texture, FeatureUses& uses);

}  // namespace firstlight::render
