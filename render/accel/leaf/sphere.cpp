#include "render/accel/leaf/sphere.h"

#include <limits>

namespace firstlight::render {

SphereBlock sphere_block(std::span<const RoundSphere> all, const SphereGroup& group) {
  SphereBlock block{};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    block.radius_squared[lane] = -std::numeric_limits<double>::infinity();
    if (group[lane] == kNoSphere) continue;
    const RoundSphere& round = all[group[lane]];
    for (int axis = 0; axis < 3; ++axis) {
      block.center[axis][lane] = round.sphere->center()[axis];
      block.bounds[2 * axis][lane] = round.bounds.low[axis];
      block.bounds[2 * axis + 1][lane] = round.bounds.high[axis];
    }
    block.hidden_from[lane] = round.head.hidden_from;
    block.hidden_from_any |= round.head.hidden_from;
    block.opaque |= static_cast<std::uint8_t>(round.head.opaque ? 1u << lane : 0u);
    block.radius_squared[lane] = round.sphere->radius_squared();
  }
  return block;
}

}  // namespace firstlight::render
