#pragma once

#include "render/scene/object_group.h"
#include "render/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace firstlight::render {

/// Numbers the textures of a scene while it is built: one entry for each texture in each place. Textures without
/// patterns look the same everywhere, so one entry serves all their places.
///
/// Memory   Beside the entries themselves a few bytes each: the table that finds them holds only their numbers.
class TextureTable {
 public:
  /// The entry of `texture`, placed by `to_world`. Pre: not null.
  std::uint32_t index_of(const TexturePtr& texture, const Transform& to_world);
  /// The same of one that is asked for this once, so that it need not be found again.
  std::uint32_t index_of_unshared(const TexturePtr& texture, const Transform& to_world);
  const Texture& texture(std::uint32_t index) const { return *entries_[index].texture; }
  bool opaque(std::uint32_t index) const { return kinds_[index] != SurfaceKind::clear; }
  SurfaceKind kind(std::uint32_t index) const { return kinds_[index]; }
  std::vector<PlacedTexture> take() { return std::move(entries_); }

 private:
  std::size_t home_of(const Texture* texture, const Transform& place) const;
  void grow();
  std::uint32_t add(const TexturePtr& texture, const Transform& place);

  std::vector<PlacedTexture> entries_;
  std::vector<SurfaceKind> kinds_;
  std::vector<std::uint32_t> slots_;  // entries by hash, each at its home or, where that is taken, at the next free one
  std::size_t taken_slots_ = 0;
};

}  // namespace firstlight::render
