#include "render/shape/land.h"

#include "render/shape/tolerance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace firstlight::render {

Land::Land(HeightFieldParameters parameters) : given_(std::move(parameters)) {
  const auto [low, high] = std::ranges::minmax(given_.heights);
  low_ = std::max(static_cast<double>(low), given_.water_level * kFull) - kRoom;
  high_ = static_cast<double>(high) + kRoom;
  make_levels();
  if (given_.smooth) make_normals();
}

Transform Land::to_unit() const {
  return Transform::scaling(Vec3(1.0 / (given_.columns - 1.0), 1.0 / kFull, 1.0 / (given_.rows - 1.0)));
}

bool Land::holds(const Vec3& p) const {
  if (p.x < 0.0 || p.x >= given_.columns - 1.0 || p.z < 0.0 || p.z >= given_.rows - 1.0 || p.y >= high_) return false;
  if (p.y < low_) return true;
  int x = static_cast<int>(p.x);
  int z = static_cast<int>(p.z);
  const auto land = [&](int at_x, int at_z) { return std::max(height(at_x, at_z), low_); };
  Vec3 normal;
  if ((p.x - x) + (p.z - z) < 1.0) {
    normal = Vec3(land(x, z) - land(x + 1, z), 1.0, land(x, z) - land(x, z + 1));
  } else {
    x = static_cast<int>(std::ceil(p.x));
    z = static_cast<int>(std::ceil(p.z));
    normal = Vec3(land(x - 1, z) - land(x, z), 1.0, land(x, z - 1) - land(x, z));
  }
  return p.dot(normal) < Vec3(x, land(x, z), z).dot(normal);
}

Vec3 Land::flat_normal(std::uint32_t face) const {
  const auto cell = static_cast<int>(face / 2);
  const int x = cell % (given_.columns - 1);
  const int z = cell / (given_.columns - 1);
  if (face % 2 == 0) return Vec3(height(x, z) - height(x + 1, z), 1.0, height(x, z) - height(x, z + 1));
  return Vec3(height(x, z + 1) - height(x + 1, z + 1), 1.0, height(x + 1, z) - height(x + 1, z + 1));
}

void Land::make_levels() {
  Level cells{given_.columns - 1, given_.rows - 1, {}};
  cells.spans.reserve(static_cast<std::size_t>(cells.columns) * static_cast<std::size_t>(cells.rows));
  for (int z = 0; z < cells.rows; ++z) {
    for (int x = 0; x < cells.columns; ++x) {
      const auto [low, high] = std::minmax({given_.heights[index(x, z)], given_.heights[index(x + 1, z)],
                                            given_.heights[index(x, z + 1)], given_.heights[index(x + 1, z + 1)]});
      cells.spans.push_back({low, high});
    }
  }
  levels_.push_back(std::move(cells));
  while (levels_.back().spans.size() > 1) {
    const Level& below = levels_.back();
    Level level{(below.columns - 1) / kShrink + 1, (below.rows - 1) / kShrink + 1, {}};
    level.spans.assign(static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows), {0xffff, 0});
    for (int z = 0; z < below.rows; ++z) {
      for (int x = 0; x < below.columns; ++x) {
        Span& span = level.spans[level.index(x / kShrink, z / kShrink)];
        const Span& part = below.at(x, z);
        span.low = std::min(span.low, part.low);
        span.high = std::max(span.high, part.high);
      }
    }
    levels_.push_back(std::move(level));
  }
}

/// The mean of those of the triangles around, kept in 16 bits. [POV-Ray 3.7]
void Land::make_normals() {
  normals_.reserve(given_.heights.size());
  for (int z = 0; z < given_.rows; ++z) {
    for (int x = 0; x < given_.columns; ++x) {
      Vec3 sum(0.0);
      const auto is_there = [&](int at_x, int at_z) {
        return at_x >= 0 && at_z >= 0 && at_x < given_.columns && at_z < given_.rows;
      };
      const auto add = [&](int x1, int z1, int x2, int z2) {
        if (!is_there(x1, z1) || !is_there(x2, z2)) return;
        const Vec3 here(x, height(x, z), z);
        Vec3 n = (Vec3(x2, height(x2, z2), z2) - here).cross(Vec3(x1, height(x1, z1), z1) - here);
        n = n.length() > kEpsilon ? n / n.length() : Vec3(0.0, 1.0, 0.0);
        sum += n.y < 0.0 ? -n : n;
      };
      add(x + 1, z, x, z + 1);
      add(x, z + 1, x - 1, z);
      add(x - 1, z, x, z - 1);
      add(x, z - 1, x + 1, z);
      sum = sum.length() > kEpsilon ? sum / sum.length() : Vec3(0.0, 1.0, 0.0);
      normals_.emplace_back(static_cast<short>(32767 * sum.x), static_cast<short>(32767 * sum.y),
                            static_cast<short>(32767 * sum.z));
    }
  }
}

}  // namespace firstlight::render
