#pragma once

#include "render/math/vec.h"

#include <cstddef>
#include <vector>

namespace firstlight::render {

/// A tile of the x-z plane: a convex polygon.
struct PolygonTile {
  std::size_t kind = 0;  ///< its place among the kinds of tiles
  std::vector<Vec2> corners = {};
  double reach = 0.0;  ///< how deep within the tile the value has gone down from its end to its begin
  /// The reach of edge i, which begins at corner i; 0 or absent: as above.
  std::vector<double> edge_reach = {};
};

/// The plane covered by tiles that repeat along two vectors. Each kind of tile has an equal part of the values from 0 to 1: at
/// its border the tile has the highest of its part, and the lowest where it is as deep as its reach, or deeper.
///
/// Cost     Of at(): the tiles that meet one parallelogram of the two vectors.
/// Threads  Immutable.
class PolygonTiling {
 public:
  /// Pre: with their repetitions the tiles cover the plane once.
  PolygonTiling(const Vec2& step1, const Vec2& step2, std::size_t kinds, const std::vector<PolygonTile>& tiles);

  double at(double x, double z) const;

 private:
  struct Edge {
    Vec2 inwards;  ///< unit
    double offset;
    double steepness;  ///< 1 / reach
  };
  struct Placed {
    std::size_t begin, end;  ///< into edges_
    double kind;
  };
  void place(const PolygonTile& tile, const Vec2& by);

  Vec2 step1_;
  Vec2 step2_;
  double area_;
  double kinds_;
  std::vector<Placed> tiles_;
  std::vector<Edge> edges_;
};

}  // namespace firstlight::render
