#include "render/surface/compiled_pattern.h"

#include "render/math/scratch.h"
#include "render/surface/compiled_pigment.h"

#include <bit>

namespace firstlight::render {

CompiledPattern::CompiledPattern(const Patterning& source, const PatternWorld& world)
    : source_(&source), moved_by_turbulence_(is_moved_by_turbulence(source.kind)) {
  const int generator = source.noise_generator != 0 ? source.noise_generator : world.noise_generator;
  field_ = make_pattern(source.kind, {source.parameters, generator, world, source.warps.turbulence, source.wave});
  if (source.kind == PatternKind::image_map || source.kind == PatternKind::material_map) {
    image_ = std::make_shared<const ImageMap>(std::get<ImageParameters>(source.parameters).image);
  }
  if (source.kind == PatternKind::pigment_pattern) {
    pigment_ = std::make_shared<const CompiledPigment>(*std::get<PigmentParameters>(source.parameters).pigment, world);
  }
}

void CompiledPattern::to_pattern(const SurfacePoints& points, Columns3<double>& there) const {
  there = points.at;
  source_->warps.to_pattern(there, points.size, moved_by_turbulence_);
}

void CompiledPattern::places(const Columns3<double>& there, const SurfacePoints& points, Column<double>& places) const {
  if (pigment_ != nullptr) {
    greys(there, points, places);
  } else {
    field_->values(there, points, places);
  }
  shape_all(source_->wave, points.size, places);
}

void CompiledPattern::greys(const Columns3<double>& there, const SurfacePoints& points, Column<double>& values) const {
  const Scratch<SurfacePoints> moved;
  const Scratch<ColorColumns> found;
  pick(points, there, points.all(), *moved);
  pigment_->colors(*moved, *found);
  for (std::size_t i = 0; i < points.size; ++i) {
    const Rgb color = found->color(i).rgb;
    const double grey = 0.297 * static_cast<double>(color.x) + 0.589 * static_cast<double>(color.y) +
                        0.114 * static_cast<double>(color.z);
    values[i] = (found->missing >> i & 1u) != 0 ? 0.0 : in_single(grey);
  }
}

void pick(const SurfacePoints& points, const Columns3<double>& at, std::uint64_t lanes, SurfacePoints& picked) {
  picked.size = 0;
  picked.on_surface = points.on_surface;
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
    const std::size_t k = picked.size++;
    picked.at.set(k, at.vector(i));
    if (!points.on_surface) continue;
    picked.place.set(k, points.place.vector(i));
    picked.normal.set(k, points.normal.vector(i));
    picked.tilted.set(k, points.tilted.vector(i));
    picked.direction.set(k, points.direction.vector(i));
    picked.uv.set(k, points.uv.vector(i));
  }
}

void to_own_coordinates(const SurfacePoints& points, SurfacePoints& there) {
  Columns3<double> at;
  for (std::size_t i = 0; i < points.size; ++i) at.set(i, Vec3(points.uv.of[0][i], points.uv.of[1][i], 0.0));
  pick(points, at, points.all(), there);
}

}  // namespace firstlight::render
