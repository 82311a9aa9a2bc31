#include "render/trace/radiance_bound.h"

#include "render/camera/lens.h"
#include "render/math/interrupt.h"
#include "render/scene/scene.h"
#include "render/trace/surface_limits.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace firstlight::render {
namespace {

// Sums of many bounds must stay within 64 bits.
constexpr double kLargest = 65536.0;
/// Longer rows of clear surfaces than this bound would allow for are not met.
constexpr double kLongestRow = 64.0;
/// Surfaces in a row, each as bright as can be: an estimate.
constexpr double kUsualRow = 4.0;

}  // namespace

RadianceBound::RadianceBound(const Scene& scene) : RadianceBound(scene, scene.camera, SurfaceTable(scene)) {}

RadianceBound::RadianceBound(const Scene& scene, const Camera& camera, const SurfaceTable& surfaces, bool with_alpha)
    : most_clear_(with_alpha ? 1.0f : 0.0f) {
  const SurfaceLimits limits(scene, surfaces, ray_origins(camera));
  known_ = limits.proven;
  const int levels = std::max(scene.settings.max_trace_level, 1);
  most_.assign(static_cast<std::size_t>(std::max(levels, 256)), 0.0f);
  double next = 0.0;
  for (int level = levels - 1; level >= 0 && !Interrupt::asked(); --level) {
    double most = std::max(next, limits.veil.over(limits.background));
    const auto include = [&](double light) {
      known_ = known_ && light <= kLargest;  // false for what is not a number, too
      most = std::max(most, light <= kLargest ? light : kLargest);
    };
    for (const SurfaceAnswer& answer : limits.answers) {
      if (level == levels - 1) {  // no rays are sent on
        include(limits.veil.over(answer.own));
        continue;
      }
      const double on_this_side = answer.from_this_side(next);
      include(limits.veil.over(on_this_side + answer.bent * next));
      const double near = limits.veil.kept * on_this_side + limits.veil.added;
      const double straight = limits.veil.kept * answer.straight;
      if (answer.straight == 0.0 || (near == 0.0 && straight <= 1.0)) continue;
      // A ray goes straight on without rising in level, so that most = near + straight * most.
      const double row = 1.0 / (1.0 - straight);
      const bool is_bounded = straight < 1.0 && row <= kLongestRow;
      known_ = known_ && is_bounded;
      include(near * (is_bounded ? row : kUsualRow));
    }
    next = most;
    // A little more than computed: roundings on the way of a ray must not exceed it.
    most_[static_cast<std::size_t>(level)] = static_cast<float>(most * (1.0 + 1e-4));
  }
}

std::int64_t RadianceBound::of_feelers(const RayTask& task) const {
  FixedRgb sum;
  std::int64_t count = 0;  // a step each, for what the light that passes may be rounded by
  task.for_each_feeler([&](std::uint32_t, const PackedRgb& packed) {
    const FixedRgb light = FixedRgb::from(packed);
    sum += {std::abs(light.r), std::abs(light.g), std::abs(light.b)};
    ++count;
  });
  return count + most_of_feelers(sum.max_magnitude());
}

}  // namespace firstlight::render
