#include "render/scene/texture_table.h"

#include <algorithm>
#include <bit>
#include <functional>

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

}  // namespace

std::size_t TextureTable::KeyHash::operator()(const Key& key) const {
  std::uint64_t hash = std::hash<const Texture*>()(key.texture);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double number = key.to_world[row][column] + 0.0;  // -0 and 0 are equal, so they must hash alike
      hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
  }
  return static_cast<std::size_t>(hash);
}

std::uint32_t TextureTable::index_of(const TexturePtr& texture, const Transform& to_world) {
  if (const auto known = plain_.find(texture.get()); known != plain_.end()) return known->second;
  if (is_plain(*texture)) return plain_[texture.get()] = enter(texture, Transform());
  const auto [found, is_new] = patterned_.try_emplace({texture.get(), to_world.matrix()}, 0u);
  if (is_new) found->second = enter(texture, to_world);
  return found->second;
}

std::uint32_t TextureTable::enter(const TexturePtr& texture, const Transform& to_world) {
  entries_.push_back({texture, to_world.inverse()});
  kinds_.push_back(surface_kind(*texture));
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

}  // namespace firstlight::render
