#include "render/light/area_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace firstlight::render {
namespace {

/// How far along its axes a point of a light is that is so many steps from the first.
Vec2 along_axes(const Light& light, const Vec2& steps) {
  const auto centred = [](double along, int size) { return size > 1 ? along / (size - 1) - 0.5 : 0.0; };
  Vec2 along(centred(steps.x, light.area->size1), centred(steps.y, light.area->size2));
  if (light.circular) {
    // A square ring becomes a round one. Where the middle of the grid is a point, it must not be the middle itself.
    constexpr double kOffCentre = 0.001;
    along += Vec2(kOffCentre);
    along *= std::max(std::abs(along.x), std::abs(along.y)) / std::sqrt(along.x * along.x + along.y * along.y);
  }
  return along;
}

}  // namespace

AreaGrid::AreaGrid(const Light& light, const Vec3& lit_point, Use use)
    : light_(light),
      area_(*light.area),
      axis1_(area_.axis1),
      axis2_(area_.axis2),
      draws_(lit_point, light.position),
      use_(use) {
  if (!light.orient) return;
  // Square, and at a right angle to the way from the point.
  constexpr double kAlmostAlongZ = 0.01;
  const Vec3 way = aim_at(light, light.position, lit_point).direction;
  const Vec3 beside = std::abs(std::abs(way.z) - 1.0) < kAlmostAlongZ ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
  const double length = axis1_.length();
  const Vec3 side = unit(way.cross(beside));
  axis1_ = side * length;
  axis2_ = unit(way.cross(side)) * length;
}

Vec3 AreaGrid::place(int u, int v) const {
  Vec2 steps(u, v);
  if (light_.jitter) {
    const auto point =
        static_cast<std::uint64_t>(u) * static_cast<std::uint64_t>(area_.size2) + static_cast<std::uint64_t>(v);
    const std::uint64_t number = 4 * point + (use_ == Use::illumination ? 2 : 0);
    steps += Vec2(draws_[number] - 0.5, draws_[number + 1] - 0.5);
  }
  return place(along_axes(light_, steps));
}

AreaTable::AreaTable(const Light& light) {
  const AreaLight& area = *light.area;
  if (light.jitter || area.points() > kMostPoints) return;
  along_.reserve(area.points());
  for (int u = 0; u < area.size1; ++u) {
    for (int v = 0; v < area.size2; ++v) along_.push_back(along_axes(light, Vec2(u, v)));
  }
}

AreaQuarters quarters_of(const AreaRectangle& r) {
  const auto halves = [](int first, int last) {
    return std::array<std::array<int, 2>, 2>{{{first, (first + last) / 2}, {(first + last + 1) / 2, last}}};
  };
  const auto columns = halves(r.u1, r.u2);
  const auto rows = halves(r.v1, r.v2);
  const std::size_t column_count = r.u1 == r.u2 ? 1 : 2;
  const std::size_t row_count = r.v1 == r.v2 ? 1 : 2;
  AreaQuarters quarters;
  for (std::size_t v = 0; v < row_count; ++v) {
    for (std::size_t u = 0; u < column_count; ++u) {
      quarters.of[quarters.size++] = {columns[u][0], rows[v][0], columns[u][1], rows[v][1]};
    }
  }
  quarters.times = static_cast<int>(4 / quarters.size);
  return quarters;
}

bool differ(const std::array<Rgb, 4>& corners) {
  constexpr double kMost = 0.1;
  const auto far = [&](std::size_t a, std::size_t b) {
    const Rgb gap = corners[a] - corners[b];
    return static_cast<double>(std::abs(gap.x) + std::abs(gap.y) + std::abs(gap.z)) > kMost;
  };
  return far(0, 1) || far(1, 3) || far(3, 2) || far(2, 0);
}

}  // namespace firstlight::render
