#include "render/surface/compiled_pattern.h"

#include <bit>

namespace firstlight::render {

CompiledPattern::CompiledPattern(const Patterning& source, const PatternWorld& world)
    : source_(&source), moved_by_turbulence_(is_moved_by_turbulence(source.kind)) {
  const int generator = source.noise_generator != 0 ? source.noise_generator : world.noise_generator;
  field_ = make_pattern(source.kind, {source.parameters, generator, world, source.warps.turbulence});
}

void CompiledPattern::to_pattern(const SurfacePoints& points, Columns3<double>& there) const {
  for (std::size_t i = 0; i < points.size; ++i) {
    there.set(i, source_->warps.to_pattern(points.at.vector(i), moved_by_turbulence_));
  }
}

void CompiledPattern::places(const Columns3<double>& there, const SurfacePoints& points, Column<double>& places) const {
  field_->values(there, points, places);
  shape_all(source_->wave, points.size, places);
}

void pick(const SurfacePoints& points, const Columns3<double>& at, std::uint64_t lanes, SurfacePoints& picked) {
  picked.size = 0;
  picked.on_surface = points.on_surface;
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
    const std::size_t k = picked.size++;
    picked.at.set(k, at.vector(i));
    if (!points.on_surface) continue;
    picked.normal.set(k, points.normal.vector(i));
    picked.tilted.set(k, points.tilted.vector(i));
    picked.direction.set(k, points.direction.vector(i));
    picked.u[k] = points.u[i];
    picked.v[k] = points.v[i];
  }
}

void to_own_coordinates(const SurfacePoints& points, SurfacePoints& there) {
  Columns3<double> at;
  for (std::size_t i = 0; i < points.size; ++i) at.set(i, Vec3(points.u[i], points.v[i], 0.0));
  pick(points, at, points.all(), there);
}

}  // namespace firstlight::render
