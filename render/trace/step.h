#pragma once

#include "render/accel/accel.h"
#include "render/film/film.h"
#include "render/scene/scene.h"
#include "render/trace/medium_table.h"
#include "render/trace/ray_task.h"

#include <array>
#include <cstdint>
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

/// One worker's tracing step: nearest hits of a batch of tasks, then local shading. It never recurses along a ray tree and never
/// traces a feeler it spawns.
///
/// Sum rule  pixel = sum over tasks of task.weight * local, so child.weight = task.weight * factor. Lights are added as if
///           unoccluded; a shadow child carries what it must take back when it is blocked.
/// Source    Yagel & Meeker 1997, eq. 3-9; the local terms, weights and levels are POV-Ray 3.7's.
/// Order     The contributions and tasks of a batch do not depend on how tasks are grouped into batches.
/// Threads   One Stepper a thread.
class Stepper {
 public:
  explicit Stepper(const TraceContext& context);

  /// Traces `tasks`, replacing light() and spawned() by what comes of them. Pre: `tasks` is not spawned() itself.
  void step(std::span<const RayTask> tasks);

  std::span<const Contribution> light() const { return light_; }
  std::span<const RayTask> spawned() const { return spawned_; }
  /// Since construction.
  const RayCounts& counts() const { return counts_; }

 private:
  void step_radiance(std::span<const RayTask> tasks);
  void step_shadow(std::span<const RayTask> tasks);
  void shade(const RayTask& task, const Ray& ray, const Hit& hit);
  /// Reflection whose colour is raised to a power: the subtree is evaluated here, depth first. [docs/architecture.md, "Sealed tasks"]
  void add_sealed(const RayTask& root, const Rgb& weight, double exponent);
  Rgb passing_light(const RayTask& feeler, Ray ray, double distance);

  TraceContext context_;
  std::vector<RayQuery> queries_;
  std::vector<Hit> hits_;
  std::vector<std::uint8_t> blocked_;
  std::vector<std::uint32_t> order_;
  std::vector<Contribution> light_;
  std::vector<RayTask> spawned_;
  RayCounts counts_;
};

/// Whether POV-Ray would trace the task at all (max_trace_level, adc_bailout); others add nothing.
bool is_worth_tracing(const Settings& settings, const RayTask& task);

}  // namespace firstlight::render
