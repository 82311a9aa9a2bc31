#pragma once

#include "render/accel/float_box.h"
#include "render/accel/leaf/head.h"
#include "render/accel/wide_tree.h"
#include "render/shape/sphere.h"

#include <cstdint>
#include <span>

namespace firstlight::render {

/// Eight spheres side by side. An unused lane has a radius squared of minus infinity, so no ray meets it.
struct alignas(64) SphereBlock {
  double center[3][kLanes];
  double radius_squared[kLanes];
  float bounds[6][kLanes];           ///< as in WideNode, without its room
  std::uint8_t hidden_from[kLanes];  ///< LeafHead::hidden_from
  std::uint8_t hidden_from_any;      ///< the bits of all
  std::uint8_t opaque;               ///< bit l: LeafHead::opaque of lane l
};

/// A sphere before it has its place in a block.
struct RoundSphere {
  const Sphere* sphere;
  FloatBox bounds;
  LeafHead head;
};

/// Those of `all` that are in the group, side by side.
SphereBlock sphere_block(std::span<const RoundSphere> all, const SphereGroup& group);

}  // namespace firstlight::render
