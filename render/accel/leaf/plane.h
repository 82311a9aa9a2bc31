#pragma once

#include "render/accel/leaf/head.h"
#include "render/math/vec.h"

#include <span>

namespace firstlight::render {

/// A plane, which every ray meets: it is in no tree.
struct PlaneLeaf {
  Vec3 normal;
  double offset;
  LeafHead head;
  bool in_doubt = false;  ///< another lies where it lies
};

/// Marks planes that lie in one place.
void mark_coincident(std::span<PlaneLeaf> planes);

}  // namespace firstlight::render
