#pragma once

#include "render/math/color.h"
#include "render/surface/surface_table.h"
#include "render/trace/trace_context.h"

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
  /// Pre: `surfaces` outlives it.
  Shadow(const TraceContext& context, const SurfaceTable& surfaces);

  /// False where whatever casts a shadow takes all light.
  bool has_transparent_casters() const { return has_transparent_casters_; }
  /// Of a light that is projected through something: ends the ray to it there, for what is beyond casts no shadow, nor does
  /// anything if the light is without shadow. False where the ray does not lead through it. `max_depth`: to the light.
  bool end_at_window(const Light& light, const Ray& ray, double& max_depth);
  /// Of light that goes along each of the rays, from their least depth to their largest: the share that passes.
  /// `media`: what their origins are in. Pre: equal sizes.
  void passing(const RayBlock& rays, std::span<const std::uint32_t> media, std::span<Rgb> shares);
  /// The same of one ray that meets nothing opaque, and which reaches `distance` far.
  Rgb passing_light(std::uint32_t medium, Ray ray, double distance);

 private:
  /// Takes from `light` what the surface keeps. False where it has no texture.
  bool filter_light(const Hit& hit, const Ray& ray, Rgb& light);

  TraceContext context_;
  const SurfaceTable& surfaces_;
  bool has_transparent_casters_;
  std::unique_ptr<SurfacePoints> asked_;
  std::vector<Crossing> crossings_;  ///< of a window
};

}  // namespace firstlight::render
