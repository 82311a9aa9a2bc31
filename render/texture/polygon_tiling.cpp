#include "render/texture/polygon_tiling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace firstlight::render {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

struct Rectangle {
  Vec2 low{std::numeric_limits<double>::max()};
  Vec2 high{std::numeric_limits<double>::lowest()};

  void add(const Vec2& point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
  bool meets(const Rectangle& other, const Vec2& moved_by) const {
    return low.x <= other.high.x + moved_by.x && other.low.x + moved_by.x <= high.x &&
           low.y <= other.high.y + moved_by.y && other.low.y + moved_by.y <= high.y;
  }
};

}  // namespace

PolygonTiling::PolygonTiling(const Vec2& step1, const Vec2& step2, std::size_t kinds,
                             const std::vector<PolygonTile>& tiles)
    : step1_(step1), step2_(step2), area_(cross(step1, step2)), kinds_(static_cast<double>(kinds)) {
  Rectangle cell;
  for (const Vec2& corner : {Vec2(0.0), step1, step2, step1 + step2}) cell.add(corner);
  constexpr int kFarthest = 4;  // in steps, from a tile to the cell at the origin
  for (const PolygonTile& tile : tiles) {
    Rectangle box;
    for (const Vec2& corner : tile.corners) box.add(corner);
    for (int i = -kFarthest; i <= kFarthest; ++i) {
      for (int j = -kFarthest; j <= kFarthest; ++j) {
        const Vec2 by = step1 * static_cast<double>(i) + step2 * static_cast<double>(j);
        if (cell.meets(box, by)) place(tile, by);
      }
    }
  }
}

void PolygonTiling::place(const PolygonTile& tile, const Vec2& by) {
  const std::size_t corners = tile.corners.size();
  Vec2 middle(0.0);
  for (const Vec2& corner : tile.corners) middle += corner / static_cast<double>(corners);
  const std::size_t begin = edges_.size();
  for (std::size_t i = 0; i < corners; ++i) {
    const Vec2& corner = tile.corners[i];
    const Vec2 along = (tile.corners[(i + 1) % corners] - corner).normalized();
    const double side = cross(along, middle - corner) < 0.0 ? -1.0 : 1.0;
    const Vec2 inwards(-along.y * side, along.x * side);
    const double own = i < tile.edge_reach.size() ? tile.edge_reach[i] : 0.0;
    edges_.push_back(Edge{inwards, inwards.dot(corner + by), 1.0 / (own > 0.0 ? own : tile.reach)});
  }
  tiles_.push_back(Placed{begin, edges_.size(), static_cast<double>(tile.kind)});
}

double PolygonTiling::at(double x, double z) const {
  const Vec2 point(x, z);
  const double across = std::floor(cross(point, step2_) / area_);
  const double up = std::floor(cross(step1_, point) / area_);
  const Vec2 place = point - step1_ * across - step2_ * up;
  // The tile in which the place is, or, where rounding leaves it between two, the one it is least outside of.
  double least_outside = std::numeric_limits<double>::lowest();
  double value = 0.0;
  for (const Placed& tile : tiles_) {
    double inside = std::numeric_limits<double>::max();
    double height = 0.0;
    for (std::size_t i = tile.begin; i < tile.end && inside > least_outside; ++i) {
      const Edge& edge = edges_[i];
      const double depth = edge.inwards.dot(place) - edge.offset;
      inside = std::min(inside, depth);
      height = std::max(height, 1.0 - depth * edge.steepness);
    }
    if (inside <= least_outside) continue;
    // A tile that goes down to where another kind begins stays in its own part of a map.
    constexpr double kAboveTheNext = 1e-7;
    value = (tile.kind + std::clamp(height, tile.kind > 0.0 ? kAboveTheNext : 0.0, 1.0)) / kinds_;
    if (inside >= 0.0) break;
    least_outside = inside;
  }
  return value;
}

}  // namespace firstlight::render
