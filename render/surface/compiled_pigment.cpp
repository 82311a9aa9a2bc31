#include "render/surface/compiled_pigment.h"

#include "render/math/scratch.h"

#include <bit>

namespace firstlight::render {
namespace {

/// a + t (b - a), every step rounded to single precision as POV-Ray's colours are.
float blend(float a, float b, double t) { return a + static_cast<float>((b - a) * t); }

FilteredColor blend(const FilteredColor& a, const FilteredColor& b, double t) {
  return {{blend(a.rgb.x, b.rgb.x, t), blend(a.rgb.y, b.rgb.y, t), blend(a.rgb.z, b.rgb.z, t)},
          blend(a.filter, b.filter, t),
          blend(a.transmit, b.transmit, t)};
}

}  // namespace

CompiledPigment::CompiledPigment(const Pigment& source, const PatternWorld& world)
    : source_(&source), even_(even_color(source, world.quick_colors)), pattern_(*source.pattern, world) {
  if (!source.pattern->pigments) {
    if (!is_plain() && pattern_.has_places() && pattern_.image() == nullptr) map_ = ColorMapTable(map_of(source));
    return;
  }
  for (const MapEntry<Pigment>& entry : source.pattern->pigments->entries) entries_.emplace_back(entry.value, world);
}

void CompiledPigment::colors(const SurfacePoints& points, ColorColumns& colors) const {
  colors.missing = 0;
  const PatternKind kind = source_->pattern->kind;
  if (is_plain()) {
    for (std::size_t i = 0; i < points.size; ++i) colors.set(i, *even_);
  } else if (kind == PatternKind::uv_mapping) {
    const Scratch<SurfacePoints> own;
    to_own_coordinates(points, *own);
    entries_.front().colors(*own, colors);
  } else if (pattern_.image() != nullptr) {
    pictured(points, colors);
  } else if (kind == PatternKind::average) {
    averaged(points, colors);
  } else if (entries_.empty()) {
    mapped(points, colors);
  } else {
    blended(points, colors);
  }
}

FilteredColor CompiledPigment::color_at(const Vec3& point) const {
  if (is_plain()) return *even_;
  SurfacePoints points;
  points.size = 1;
  points.at.set(0, point);
  ColorColumns found;
  colors(points, found);
  return found.color(0);
}

void CompiledPigment::mapped(const SurfacePoints& points, ColorColumns& colors) const {
  Columns3<double> there;
  Column<double> places;
  pattern_.to_pattern(points, there);
  pattern_.places(there, points, places);
  map_.colors(places, points.size, colors);
}

void CompiledPigment::pictured(const SurfacePoints& points, ColorColumns& colors) const {
  const FilteredColor nothing{Rgb(1.0f), 0.0f, 1.0f};
  Columns3<double> there;
  pattern_.to_pattern(points, there);
  for (std::size_t i = 0; i < points.size; ++i) {
    const auto place = pattern_.image()->place(there.vector(i));
    colors.set(i, place ? pattern_.image()->at(*place).color : nothing);
    if (!place) colors.missing |= std::uint64_t{1} << i;
  }
}

// Entries are asked where the warps lead, turbulence included.
void CompiledPigment::averaged(const SurfacePoints& points, ColorColumns& colors) const {
  const Scratch<SurfacePoints> moved;
  const Scratch<ColorColumns> found;
  Columns3<double> there;
  pattern_.to_pattern(points, there);
  pick(points, there, points.all(), *moved);
  for (std::size_t i = 0; i < points.size; ++i) colors.set(i, {});
  float total = 0.0f;
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const auto share = static_cast<float>(source_->pattern->pigments->entries[k].position);
    entries_[k].colors(*moved, *found);
    for (std::size_t i = 0; i < points.size; ++i) {
      const FilteredColor sum = colors.color(i);
      const FilteredColor more = found->color(i);
      colors.set(i,
                 {sum.rgb + more.rgb * share, sum.filter + more.filter * share, sum.transmit + more.transmit * share});
    }
    total += share;
  }
  for (std::size_t i = 0; i < points.size; ++i) {
    const FilteredColor sum = colors.color(i);
    colors.set(i, {sum.rgb / total, sum.filter / total, sum.transmit / total});
  }
}

void CompiledPigment::blended(const SurfacePoints& points, ColorColumns& colors) const {
  const Scratch<SurfacePoints> picked;
  const Scratch<ColorColumns> found;
  const Scratch<ColorColumns> above;
  Columns3<double> there;
  Column<double> values;
  pattern_.to_pattern(points, there);
  pattern_.places(there, points, values);
  const auto& map = source_->pattern->pigments->entries;
  std::array<MapPlace, kRaysAtOnce> places;
  for (std::size_t i = 0; i < points.size; ++i) {
    places[i] = place_in_map(values[i], static_cast<std::uint32_t>(map.size()),
                             [&](std::uint32_t k) { return stored_position(map[k].position); });
  }
  // A point has a colour where one of its two entries has.
  std::uint64_t has_some = 0;
  for_each_entry(static_cast<std::uint32_t>(map.size()), points.size, places,
                 [&](std::uint32_t entry, std::uint64_t lanes) {
                   pick(points, there, lanes, *picked);
                   entries_[entry].colors(*picked, *found);
                   for (std::size_t k = 0; lanes != 0; lanes &= lanes - 1, ++k) {
                     const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
                     if (places[i].below == entry) colors.set(i, found->color(k));
                     if (places[i].above == entry) above->set(i, found->color(k));
                     if ((found->missing >> k & 1u) == 0) has_some |= std::uint64_t{1} << i;
                   }
                 });
  for (std::size_t i = 0; i < points.size; ++i) {
    if (places[i].below == places[i].above) continue;
    colors.set(i, blend(colors.color(i), above->color(i), places[i].fraction));
  }
  colors.missing = points.all() & ~has_some;
}

}  // namespace firstlight::render
