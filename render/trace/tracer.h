#pragma once

#include "render/math/fixed_rgb.h"
#include "render/math/vec.h"
#include "render/trace/ray_counts.h"
#include "render/trace/ray_task.h"
#include "render/trace/trace_context.h"

#include <memory>
#include <span>

namespace firstlight::render {

class Stepper;
class SurfaceTable;

/// A scene's surfaces as tracing asks them, shared between tracers.
std::shared_ptr<const SurfaceTable> make_surfaces(const Scene& scene);

/// A Stepper (render/trace/step.h) for those who decide what is traced and when: this header shows them rays and light,
/// and neither shapes nor textures.
///
/// Cost     A call a step.
/// Threads  One Tracer a thread.
class Tracer {
 public:
  /// `surfaces`: of the context's scene.
  Tracer(const TraceContext& context, std::shared_ptr<const SurfaceTable> surfaces);
  ~Tracer();

  /// As Stepper's.
  void step(std::span<const RayTask> tasks);
  void step_primary(std::span<const RayTask> tasks, std::span<const Ray> rays);
  std::span<const Contribution> light() const;
  std::span<const Clearness> clearness() const;
  std::span<const RayTask> spawned() const;
  const RayCounts& counts() const;

 private:
  std::unique_ptr<Stepper> stepper_;
};

}  // namespace firstlight::render
