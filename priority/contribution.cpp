#include "priority/log_scale.h"
#include "priority/schemes.h"

#include <algorithm>
#include <cstdint>

namespace firstlight::priority {
namespace {

/// The share of its weight that a radiance ray counts for, against the light that a feeler may take back. A ray brings
/// less light than its weight allows, and costs several times what a feeler does. On the sphere-flake in a room of
/// mirrors the convergence is the same for shares from 1 to 1/16, within the noise, but the longest queue at 1/8 is
/// less than half of that at 1.
constexpr float kRadianceShare = 0.125f;

constexpr LogScale kScale(-30, 10, 4);

/// The more a ray can change its pixel, the earlier it leaves: by the largest component of the weight of a radiance
/// ray, or of the light that a feeler would take back. Buckets are a sixteenth of an octave wide.
/// Source   Yagel & Meeker 1997, section 4, "contribution".
class Contribution final : public Scheme {
 public:
  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      keys[i] = kScale.of(tasks[i].kind == render::RayKind::shadow
                              ? most_at_stake(tasks[i])
                              : render::max_magnitude(tasks[i].radiance.weight()) * kRadianceShare);
    }
  }
  Key key_count() const override { return kScale.count(); }
  bool tells_pixels_apart() const override { return false; }

 private:
  static float most_at_stake(const render::RayTask& feelers) {
    float most = 0.0f;
    feelers.for_each_feeler([&](std::uint32_t, const render::PackedRgb& light) {
      most = std::max(most, render::max_magnitude(light.unpack()));
    });
    return most;
  }
};

}  // namespace

SchemePtr make_contribution(const SchemeInput&, SchemeText*) { return std::make_shared<Contribution>(); }

}  // namespace firstlight::priority
