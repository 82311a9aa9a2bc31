#pragma once

#include "render/scene/scene.h"

#include <algorithm>

namespace firstlight::render {

/// The most that fogs and rainbows make of light, of any channel.
struct VeilLimits {
  double kept = 1.0;
  double added = 0.0;
  double least = 0.0;  ///< the most of a way on which nothing of the light is left

  double over(double light) const { return std::max(kept * light + added, least); }
};

// Each sets `proven` to false if there is no largest value.
VeilLimits veil_limits(const Scene& scene, bool& proven);
/// The most that a ray sees which meets nothing.
double sky_limit(const Scene& scene, bool& proven);

/// Whether sky, fog or rainbow may make negative light of light that is not.
bool surroundings_may_be_negative(const Scene& scene);

}  // namespace firstlight::render
