#include "render/surface/compiled_normal.h"

#include "render/math/scratch.h"

#include <array>
#include <bit>

namespace firstlight::render {
namespace {

/// Corners of a tetrahedron about the origin. [POV-Ray 3.7, to the digits that it uses]
const std::array<Vec3, 4> kCorners = {Vec3(0.942809041, -0.333333333, 0.0),
                                      Vec3(-0.471404521, -0.333333333, 0.816496581),
                                      Vec3(-0.471404521, -0.333333333, -0.816496581), Vec3(0.0, 1.0, 0.0)};
/// Factor on bump_size where heights are tilted by, at the usual distance of the corners.
constexpr double kHeightScale = -5.0;
constexpr double kUsualAccuracy = 0.02;

/// A cubic through heights with slopes at both ends, t from 0 to 1.
double hermite(double t, const SlopePoint& a, const SlopePoint& b) {
  const double t2 = t * t;
  const double rise = a.height - b.height;
  return t2 * t * (a.slope + b.slope + 2.0 * rise) - t2 * (2.0 * a.slope + b.slope + 3.0 * rise) + t * a.slope +
         a.height;
}

}  // namespace

CompiledNormal::CompiledNormal(const Normal& source, const PatternWorld& world, bool keeps_length)
    : source_(&source),
      pattern_(source.pattern, world),
      amount_(static_cast<float>(source.amount)),
      keeps_length_(keeps_length || source.pattern.keeps_bump_size) {
  if (!source.normals) return;
  for (const MapEntry<Normal>& entry : source.normals->entries) {
    entries_.emplace_back(entry.value, world, keeps_length_);
  }
}

void CompiledNormal::tilt(const SurfacePoints& points, const Transform* placement, Columns3<double>& normals) const {
  const Patterning& pattern = pattern_.source();
  if (!entries_.empty() && pattern.kind == PatternKind::uv_mapping) {
    const Scratch<SurfacePoints> own;
    to_own_coordinates(points, *own);
    entries_.front().tilt(*own, nullptr, normals);
    return normalize_all(points.size, normals);
  }
  const NormalSpace space{placement, &pattern.warps, keeps_length_};
  Columns3<double> there;
  pattern_.to_pattern(points, there);
  space.into(points.size, normals);
  const bool by_map = !entries_.empty() && pattern.kind != PatternKind::average;
  if (by_map) {
    tilt_by_map(points, there, normals);
  } else if (!entries_.empty()) {
    tilt_by_average(points, there, normals);
  } else if (pattern_.field() != nullptr && pattern_.field()->has_tilt()) {
    pattern_.field()->tilt({amount_, pattern.wave}, there, points, normals);
  } else {
    tilt_by_heights(points, there, normals);
  }
  space.out_of(points.size, normals);
  if (by_map) normalize_all(points.size, normals);
}

void CompiledNormal::tilt_by_map(const SurfacePoints& points, const Columns3<double>& there,
                                 Columns3<double>& normals) const {
  const Scratch<SurfacePoints> picked;
  const auto& map = source_->normals->entries;
  Column<double> values;
  pattern_.places(there, points, values);
  std::array<MapPlace, kRaysAtOnce> places;
  for (std::size_t i = 0; i < points.size; ++i) {
    places[i] = place_in_map(values[i], static_cast<std::uint32_t>(map.size()),
                             [&](std::uint32_t k) { return stored_position(map[k].position); });
  }
  const Columns3<double> start = normals;
  Columns3<double> above;
  for_each_entry(static_cast<std::uint32_t>(map.size()), points.size, places,
                 [&](std::uint32_t entry, std::uint64_t lanes) {
                   pick(points, there, lanes, *picked);
                   Columns3<double> tilted;
                   std::size_t k = 0;
                   for (std::uint64_t rest = lanes; rest != 0; rest &= rest - 1, ++k) {
                     tilted.set(k, start.vector(static_cast<std::size_t>(std::countr_zero(rest))));
                   }
                   entries_[entry].tilt(*picked, nullptr, tilted);
                   k = 0;
                   for (std::uint64_t rest = lanes; rest != 0; rest &= rest - 1, ++k) {
                     const auto i = static_cast<std::size_t>(std::countr_zero(rest));
                     if (places[i].below == entry) normals.set(i, tilted.vector(k));
                     if (places[i].above == entry) above.set(i, tilted.vector(k));
                   }
                 });
  for (std::size_t i = 0; i < points.size; ++i) {
    if (places[i].below == places[i].above) continue;
    const double t = places[i].fraction;
    normals.set(i, normals.vector(i) * (1.0 - t) + above.vector(i) * t);
  }
}

void CompiledNormal::tilt_by_average(const SurfacePoints& points, const Columns3<double>& there,
                                     Columns3<double>& normals) const {
  const Scratch<SurfacePoints> moved;
  pick(points, there, points.all(), *moved);
  const Columns3<double> start = normals;
  for (std::size_t i = 0; i < points.size; ++i) normals.set(i, Vec3(0.0));
  float total = 0.0f;
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const auto share = static_cast<float>(source_->normals->entries[k].position);
    Columns3<double> tilted = start;
    entries_[k].tilt(*moved, nullptr, tilted);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < points.size; ++i) {
        normals.of[axis][i] += tilted.of[axis][i] * static_cast<double>(share);
      }
    }
    total += share;
  }
  for (std::size_t i = 0; i < points.size; ++i) normals.set(i, normals.vector(i) / static_cast<double>(total));
}

void CompiledNormal::tilt_by_heights(const SurfacePoints& points, const Columns3<double>& there,
                                     Columns3<double>& normals) const {
  const double reach = static_cast<float>(source_->accuracy);
  const double amount = amount_ * kHeightScale * (kUsualAccuracy / reach);
  Columns3<double> corner;
  Column<double> heights;
  for (const Vec3& toward : kCorners) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double step = toward[static_cast<int>(axis)] * reach;
      for (std::size_t i = 0; i < points.size; ++i) corner.of[axis][i] = there.of[axis][i] + step;
    }
    pattern_.places(corner, points, heights);
    for (std::size_t i = 0; i < points.size; ++i) heights[i] = height(heights[i]) * amount;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double side = toward[static_cast<int>(axis)];
      for (std::size_t i = 0; i < points.size; ++i) normals.of[axis][i] += side * heights[i];
    }
  }
}

double CompiledNormal::height(double value) const {
  if (!source_->slopes) return value;
  const auto& map = source_->slopes->entries;
  const MapPlace place = place_in_map(value, static_cast<std::uint32_t>(map.size()),
                                      [&](std::uint32_t k) { return stored_position(map[k].position); });
  if (place.below == place.above) return map[place.above].value.height;
  return hermite(place.fraction, map[place.below].value, map[place.above].value);
}

}  // namespace firstlight::render
