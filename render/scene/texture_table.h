#pragma once

#include "render/scene/object_group.h"
#include "render/scene/scene.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace firstlight::render {

/// Numbers the textures of a scene while it is built: one entry for each texture in each place. Textures without
/// patterns look the same everywhere, so one entry serves all their places.
class TextureTable {
 public:
  /// The entry of `texture`, placed by `to_world`. Pre: not null.
  std::uint32_t index_of(const TexturePtr& texture, const Transform& to_world);
  const Texture& texture(std::uint32_t index) const { return *entries_[index].texture; }
  bool opaque(std::uint32_t index) const { return kinds_[index] != SurfaceKind::clear; }
  SurfaceKind kind(std::uint32_t index) const { return kinds_[index]; }
  std::vector<PlacedTexture> take() { return std::move(entries_); }

 private:
  std::uint32_t enter(const TexturePtr& texture, const Transform& to_world);

  struct Key {
    const Texture* texture;
    Mat4 to_world;

    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };

  std::vector<PlacedTexture> entries_;
  std::vector<SurfaceKind> kinds_;
  std::unordered_map<const Texture*, std::uint32_t> plain_;
  std::unordered_map<Key, std::uint32_t, KeyHash> patterned_;
};

}  // namespace firstlight::render
