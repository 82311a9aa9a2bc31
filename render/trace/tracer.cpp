#include "render/trace/tracer.h"

#include "render/surface/surface_table.h"
#include "render/trace/step.h"

#include <utility>

namespace firstlight::render {

std::shared_ptr<const SurfaceTable> make_surfaces(const Scene& scene) { return std::make_shared<SurfaceTable>(scene); }

Tracer::Tracer(const TraceContext& context, std::shared_ptr<const SurfaceTable> surfaces)
    : stepper_(std::make_unique<Stepper>(context, std::move(surfaces))) {}

Tracer::~Tracer() = default;

void Tracer::step(std::span<const RayTask> tasks) { stepper_->step(tasks); }

void Tracer::step_primary(std::span<const RayTask> tasks, std::span<const Ray> rays) {
  stepper_->step_primary(tasks, rays);
}

std::span<const Contribution> Tracer::light() const { return stepper_->light(); }

std::span<const Clearness> Tracer::clearness() const { return stepper_->clearness(); }
std::span<const RayTask> Tracer::spawned() const { return stepper_->spawned(); }

const RayCounts& Tracer::counts() const { return stepper_->counts(); }

}  // namespace firstlight::render
