#pragma once

#include "render/shape/shape.h"

#include <memory>
#include <vector>

namespace firstlight::render {

/// The textures that a shape shows at one point.
inline std::vector<TextureShare> textures_at(const Shape& shape, const Vec3& point, const Crossing& crossing = {}) {
  const auto places = std::make_unique<SurfacePlaces>();
  places->point.set(0, point);
  places->crossing[0] = &crossing;
  std::vector<TextureShare> shares;
  shape.textures(*places, 0, 1, shares);
  return shares;
}

}  // namespace firstlight::render
