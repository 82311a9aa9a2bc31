#pragma once

#include "render/scene/scene.h"
#include "render/shape/shape.h"

#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// The data that every leaf has of the solid that it stands for.
struct LeafHead {
  const Shape* shape = nullptr;  ///< null for a solid that is more than one shape
  std::uint32_t part = kNoIndex;
  std::uint32_t solid = kNoIndex;
  std::uint8_t hidden_from = 0;
  bool opaque = false;  ///< for a solid of several parts: any of them
};

/// How many shapes of a block are tested at once.
constexpr std::size_t kLanes = 8;

}  // namespace firstlight::render
