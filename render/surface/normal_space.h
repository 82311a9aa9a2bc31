#pragma once

#include "render/math/columns.h"
#include "render/math/transform.h"
#include "render/texture/warp.h"

#include <cstddef>

namespace firstlight::render {

/// The way of normals into a space in which they are tilted, and back.
struct NormalSpace {
  const Transform* placement = nullptr;  ///< from the scene to the space; null: they are one
  const Warps* warps = nullptr;          ///< from the pattern to the space; of all of them transformations alone count
  bool keeps_length = false;             ///< no_bump_scale: a space that stretches normals makes bumps weaker

  /// Moves the first `count`.
  void into(std::size_t count, Columns3<double>& normals) const;
  void out_of(std::size_t count, Columns3<double>& normals) const;
};

/// Gives the first `count` unit length, but for those that are 0.
void normalize_all(std::size_t count, Columns3<double>& normals);

}  // namespace firstlight::render
