#pragma once

#include "render/accel/accel.h"
#include "render/math/color.h"
#include "render/scene/scene.h"
#include "render/surface/surface_table.h"
#include "render/trace/medium_table.h"
#include "render/trace/trace_context.h"
#include "render/trace/veil.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace firstlight::render {

/// Finds how much light passes along straight ways between surfaces and lights.
///
/// Source   POV-Ray 3.7: what filters and what is clear in the layers of what is met, and what fades inside of matter.
/// Threads  One a thread.
class Shadow {
 public:
  /// Pre: `surfaces` and `veils` outlive it.
  Shadow(const TraceContext& context, const SurfaceTable& surfaces, const Veils& veils);

  /// False where of all light either nothing is taken or everything.
  bool takes_parts() const { return takes_parts_; }
  /// Ends the ray to a light that is projected through something at that window: nothing beyond casts a shadow, nor
  /// does anything if the light is without shadow. False where the ray does not lead through it. `max_depth`: to the
  /// light.
  bool end_at_window(const Light& light, const Ray& ray, double& max_depth);
  /// Finds the share that passes of the light along each of the rays, from their least depth to their largest. `media`:
  /// what their origins are in; `lights`: by number. Pre: equal sizes.
  void passing(const RayBlock& rays, std::span<const std::uint32_t> media, std::span<const std::uint32_t> lights,
               std::span<Rgb> shares);
  /// The same of those rays whose bit is set in `open`, which meet nothing opaque; the others' shares stay. Pre:
  /// takes_parts().
  void pass_surfaces(const RayBlock& rays, std::uint64_t open, std::span<const std::uint32_t> media,
                     std::span<const std::uint32_t> lights, std::span<Rgb> shares);

 private:
  /// The rest of a ray's way to its light, and the rest of the light.
  struct Way {
    std::size_t number;  ///< of the ray
    Ray ray;
    double distance;
    std::uint32_t medium;  ///< that it is in
    bool through_fog;      ///< fog weakens the light
    Rgb passed;
  };

  /// Leaves those of ways_ that `keep` says.
  template <class Keep>
  void keep_ways(const Keep& keep);
  /// Takes the ray through the surface.
  void pass(const Hit& hit, Way& way);
  void pass_fog(Way& way, double depth) const;
  /// The share that is left at the end of the way.
  Rgb arriving(Way& way) const;
  /// Takes from `light` what the surface keeps. False where it has no texture.
  bool filter_light(const Hit& hit, const Ray& ray, Rgb& light);
  /// Sets asked_ to the point of a surface. `whole`: with all that may be asked of it.
  void ask_at(const Crossing& crossing, const Vec3& point, const Ray& ray, bool whole);

  TraceContext context_;
  const SurfaceTable& surfaces_;
  const Veils& veils_;
  bool takes_parts_;
  std::unique_ptr<SurfacePoints> asked_;
  CoatList coats_;
  std::vector<TextureShare> worn_;
  std::vector<Way> ways_;
  std::unique_ptr<RayBlock> block_;
  std::array<Hit, kRaysAtOnce> hits_;
  std::vector<Crossing> crossings_;  ///< of a window
};

}  // namespace firstlight::render
