#pragma once

#include "render/math/ray_columns.h"
#include "render/math/transform.h"
#include "render/scene/scene.h"
#include "render/surface/compiled_pigment.h"
#include "render/trace/medium_table.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace firstlight::render {

/// The matter along a ray, between its origin and what it meets: light becomes kept * light + added, and what shows
/// through is less by `clear`.
struct Veil {
  Rgb kept{1.0f, 1.0f, 1.0f};
  Rgb added{0.0f, 0.0f, 0.0f};
  float clear = 1.0f;
};

/// The fogs and rainbows of a scene.
///
/// Source   POV-Ray 3.7 manual, "Fog" and "Rainbow": rainbows are behind fogs; where several fogs lie over each other,
///          their shares multiply, and what they add is not dimmed by the others; of several rainbows the mean shows.
/// Threads  Immutable.
class Veils {
 public:
  /// Pre: `scene` outlives this, unchanged.
  explicit Veils(const Scene& scene);

  bool empty() const { return fogs_.empty() && bows_.empty(); }
  /// Veils of the first `count` rays, with directions of unit length, from the origin to `depth`; those that are not in
  /// `who` have none.
  void across(std::uint64_t who, std::size_t count, const RayColumns& rays, const Column<double>& depth,
              std::span<Veil> veils) const;
  /// Whether fogs weaken the light on its way to surfaces.
  bool weaken(const Light& light) const { return !fogs_.empty() && light.media_attenuation && light.media_interaction; }
  /// The share of such a light that is left.
  Rgb left_of_light(const Ray& ray, double depth) const;

 private:
  struct Bow {
    const Rainbow* source;
    Vec3 right;
    double inner;                            ///< radians, from the direction
    double width;                            ///< radians
    double fading;                           ///< radians on which the ends of the arc fade
    std::unique_ptr<const Pigment> pigment;  ///< along x
    std::unique_ptr<const CompiledPigment> colors;
  };

  static void add_fog(const Fog& fog, double share, Veil& veil);
  Veil bows(const Ray& ray, double depth) const;
  /// The bow's own veil; nothing where it does not show. `number`: of the bow, for its jitter.
  std::optional<Veil> bow(const Bow& bow, const Ray& ray, double depth, std::uint64_t number) const;

  std::vector<const Fog*> fogs_;
  std::vector<Bow> bows_;
  int noise_generator_;
};

/// Depth of what is behind everything.
constexpr double kSkyDepth = 2e10;

/// Whether all that a ray in `medium` is inside of is hollow, so that the surroundings' fog is there.
bool is_hollow(const Scene& scene, MediumTable& media, std::uint32_t medium);

}  // namespace firstlight::render
