#pragma once

#include "render/accel/accel.h"
#include "render/math/fixed_rgb.h"
#include "render/scene/scene.h"
#include "render/trace/medium_table.h"
#include "render/trace/radiance_bound.h"
#include "render/trace/ray_task.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace firstlight::render {

/// Rays traced, by kind.
struct RayCounts {
  std::array<std::uint64_t, 4> by_kind{};  ///< indexed by RayKind

  std::uint64_t& of(RayKind kind) { return by_kind[static_cast<std::size_t>(kind)]; }
  std::uint64_t of(RayKind kind) const { return by_kind[static_cast<std::size_t>(kind)]; }
  std::uint64_t total() const { return by_kind[0] + by_kind[1] + by_kind[2] + by_kind[3]; }
  RayCounts& operator+=(const RayCounts& other);
};

/// What tracing reads: the scene, its hierarchy, and the shared table of media.
struct TraceContext {
  const Scene& scene;
  const Accel& accel;
  MediumTable& media;
};

/// One worker's tracing step: nearest hits of a batch of tasks, then local shading. It never recurses along a ray tree
/// and never traces a feeler it spawns.
///
/// Sum rule  pixel = sum over tasks of task.weight * local, so child.weight = task.weight * factor. Lights are added as
/// if
///           unoccluded; a shadow child carries what it must take back when it is blocked.
/// Source    Yagel & Meeker 1997, eq. 3-9; the local terms, weights and levels are POV-Ray 3.7's.
/// Order     The contributions and tasks of a batch do not depend on how tasks are grouped into batches.
/// Threads   One Stepper a thread.
class Stepper {
 public:
  explicit Stepper(const TraceContext& context);

  /// Traces `tasks`, replacing light() and spawned() by what comes of them. Pre: `tasks` is not spawned() itself.
  void step(std::span<const RayTask> tasks);
  /// The same for primary tasks, along rays given in full precision. Pre: equal sizes.
  void step_primary(std::span<const RayTask> tasks, std::span<const Ray> rays);

  std::span<const Contribution> light() const { return light_; }
  std::span<const RayTask> spawned() const { return spawned_; }
  /// Since construction.
  const RayCounts& counts() const { return counts_; }

 private:
  /// A layer of the texture that was met, as far as it matters to lights and reflections.
  struct Layer {
    const Finish* finish = nullptr;
    Rgb color;             ///< of the pigment
    Rgb filter;            ///< what the layers above let through
    double opacity = 1.0;  ///< brightness left to the layer's own light
    double adc_weight = 1.0;
    Rgb reflection;
  };
  /// A hit with all that shading reads again and again.
  struct Surface {
    const RayTask& task;
    const Part& part;
    const Interior& interior;
    Vec3 direction;  ///< of the ray that met it
    Vec3 point;
    Vec3 normal;  ///< unit, towards the ray's origin
    double depth;
    int level;  ///< of everything spawned here
  };

  /// `rays` are those of `tasks`; empty: to be unpacked from the tasks.
  void step_radiance(std::span<const RayTask> tasks, std::span<const Ray> rays);
  void step_shadow(std::span<const RayTask> tasks);
  void shade(const RayTask& task, const Ray& ray, const Hit& hit);
  /// Fills layers_ and adds the light that needs no light source; returns what all layers let through.
  Rgb shade_layers(const Surface& surface, const PlacedTexture& texture);
  void shade_lights(const Surface& surface);
  /// Returns true where the ray cannot leave and is reflected instead (total internal reflection).
  bool spawn_transmission(const Surface& surface, const Rgb& filter);
  void spawn_reflections(const Surface& surface);
  Rgb reflectivity(const Surface& surface, const Finish& finish, const Rgb& color, double& adc_weight) const;
  double relative_ior(const Surface& surface) const;

  /// Adds to the sum of the task at hand.
  void add_light(const Rgb& light) { sum_ += FixedRgb::from(light); }
  /// Hands the sum to the film, with what `task` and its children change of the light outstanding, and begins a new one.
  void finish(const RayTask& task);
  RayTask child_of(const Surface& surface, RayKind kind) const;
  void spawn(const RayTask& task);
  /// Adds weight * colour(root) ^ exponent: not a sum over rays, so the subtree is evaluated here, depth first.
  void add_sealed(RayTask root, const Rgb& weight, double exponent);
  Rgb trace_sealed(const RayTask& root);
  /// Share of the light that passes all that is between the feeler's origin and `distance`.
  Rgb passing_light(std::uint32_t medium, Ray ray, double distance) const;

  TraceContext context_;
  RadianceBound bound_;
  bool has_transparent_casters_ = false;
  std::vector<RayQuery> queries_;
  std::vector<Hit> hits_;
  std::vector<std::uint8_t> blocked_;
  std::vector<Layer> layers_;
  std::vector<Illumination> arriving_;  ///< from each light, at the surface at hand
  FixedRgb sum_;
  std::int64_t spawned_at_stake_ = 0;  ///< of what the task at hand has spawned
  std::vector<Contribution> light_;
  std::vector<RayTask> spawned_;
  std::unique_ptr<Stepper> sealed_;  ///< made when first needed
  RayCounts counts_;
};

/// Whether POV-Ray would trace the task at all (max_trace_level, adc_bailout); others add nothing.
bool is_worth_tracing(const Settings& settings, const RayTask& task);

}  // namespace firstlight::render
