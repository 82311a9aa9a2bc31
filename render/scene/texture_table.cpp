#include "render/scene/texture_table.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <utility>

namespace firstlight::render {
namespace {

SurfaceKind surface_kind(const Texture& texture) {
  if (!is_opaque(texture)) return SurfaceKind::clear;
  const auto any = [&](auto has) {
    return std::any_of(texture.layers.begin(), texture.layers.end(),
                       [&](const TextureLayer& layer) { return has(layer.finish); });
  };
  if (any([](const Finish& f) { return !is_black(f.reflection_min) || !is_black(f.reflection_max); })) {
    return SurfaceKind::mirror;
  }
  if (any([](const Finish& f) { return f.phong != 0.0 || f.specular != 0.0; })) return SurfaceKind::glossy;
  return SurfaceKind::plain;
}

/// The same for equal textures and places. Textures lie in memory about as they were made and are asked for in that
/// order, so neighbours get neighbouring slots, a stretch at a time: the table is walked through, not jumped about in.
std::size_t hash_of(const Texture* texture, const Transform& place) {
  constexpr std::uint64_t kFactor = 0x9e3779b97f4a7c15u;
  const std::uint64_t address = std::hash<const Texture*>()(texture);
  std::uint64_t hash = (address >> 5) + (address >> 16) * kFactor;
  if (place.is_identity()) return static_cast<std::size_t>(hash);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double number = place.matrix()[row][column] + 0.0;  // -0 and 0 are equal, so they must hash alike
      hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * kFactor;
      hash ^= hash >> 29;
    }
  }
  return static_cast<std::size_t>(hash);
}

}  // namespace

/// Pre: there are slots. Their number is a power of 2.
std::size_t TextureTable::home_of(const Texture* texture, const Transform& place) const {
  return hash_of(texture, place) & (slots_.size() - 1);
}

/// Keeps at least half of the slots free.
void TextureTable::grow() {
  constexpr std::size_t kFirstSize = 16;
  if (2 * (taken_slots_ + 1) <= slots_.size()) return;
  const std::size_t size = slots_.empty() ? kFirstSize : 2 * slots_.size();
  const std::vector<std::uint32_t> before = std::exchange(slots_, std::vector<std::uint32_t>(size, kNoIndex));
  for (const std::uint32_t entry : before) {
    if (entry == kNoIndex) continue;
    std::size_t slot = home_of(entries_[entry].texture.get(), entries_[entry].to_texture.inverse());
    while (slots_[slot] != kNoIndex) slot = (slot + 1) & (size - 1);
    slots_[slot] = entry;
  }
}

std::uint32_t TextureTable::add(const TexturePtr& texture, const Transform& place) {
  PlacedTexture& entry = entries_.emplace_back();
  entry.texture = texture;
  if (!place.is_identity()) entry.to_texture = place.inverse();
  kinds_.push_back(surface_kind(*texture));
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

std::uint32_t TextureTable::index_of_unshared(const TexturePtr& texture, const Transform& to_world) {
  return add(texture, is_plain(*texture) ? Transform() : to_world);
}

std::uint32_t TextureTable::index_of(const TexturePtr& texture, const Transform& to_world) {
  grow();
  const Transform place = is_plain(*texture) ? Transform() : to_world;
  std::size_t slot = home_of(texture.get(), place);
  for (; slots_[slot] != kNoIndex; slot = (slot + 1) & (slots_.size() - 1)) {
    const PlacedTexture& entry = entries_[slots_[slot]];
    if (entry.texture == texture && entry.to_texture.inverse_matrix() == place.matrix()) return slots_[slot];
  }
  ++taken_slots_;
  return slots_[slot] = add(texture, place);
}

}  // namespace firstlight::render
