#pragma once

#include "render/math/vec.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace firstlight::render {

/// Directions from a point in cells: those of a cube around it, of its faces +x, -x, +y, -y, +z, -z one after the
/// other. On a face, places are the coordinates along the next two axes in turn, u and v, over the depth along the
/// face's axis, from -1 to 1.
class CubeCells {
 public:
  /// The axis that a face lies across, its sign, and the axes along its edges.
  struct Face {
    int axis, u, v;
    bool negative;
  };
  static constexpr std::array<Face, 6> kFaces{
      {{0, 1, 2, false}, {0, 1, 2, true}, {1, 2, 0, false}, {1, 2, 0, true}, {2, 0, 1, false}, {2, 0, 1, true}}};

  /// Cells of one face, from the first to the last; none where the first is beyond the last.
  struct Rectangle {
    int u0 = 0;
    int u1 = -1;
    int v0 = 0;
    int v1 = -1;

    std::size_t area() const {
      return u1 < u0 || v1 < v0 ? 0 : static_cast<std::size_t>(u1 - u0 + 1) * static_cast<std::size_t>(v1 - v0 + 1);
    }
  };
  using Rectangles = std::array<Rectangle, 6>;

  /// Cells that anything reaches beyond its edge: far more than what is lost by computing with floats.
  static constexpr double kRoom = 1e-3;

  CubeCells() = default;
  /// `side`: cells along an edge.
  explicit CubeCells(int side) : side_(side) {}
  int side() const { return side_; }
  /// The place of a cell's middle along an edge.
  double middle(int cell) const { return (cell + 0.5) * 2.0 / side_ - 1.0; }

  /// Through which a box is seen, its corners given from the point.
  Rectangles seen_through(const Vec3& low, const Vec3& high) const {
    Rectangles cells;
    for (std::size_t f = 0; f < kFaces.size(); ++f) {
      const Face& face = kFaces[f];
      const double near = face.negative ? -high[face.axis] : low[face.axis];
      const double far = face.negative ? -low[face.axis] : high[face.axis];
      if (!(far > 0.0)) continue;
      const auto [u0, u1] = cells_along(low[face.u], high[face.u], near, far);
      const auto [v0, v1] = cells_along(low[face.v], high[face.v], near, far);
      cells[f] = {u0, u1, v0, v1};
    }
    return cells;
  }
  static std::size_t count_of(const Rectangles& cells) {
    std::size_t count = 0;
    for (const Rectangle& rectangle : cells) count += rectangle.area();
    return count;
  }

 private:
  /// The cells along one edge through which [low, high] is seen, at depths from `near` to `far`.
  std::pair<int, int> cells_along(double low, double high, double near, double far) const {
    const double least = near > 0.0 ? std::min(low / near, low / far) : low < 0.0 ? -1.0 : low / far;
    const double most = near > 0.0 ? std::max(high / near, high / far) : high > 0.0 ? 1.0 : high / far;
    const double half = 0.5 * side_;
    const double first = (least + 1.0) * half - kRoom;
    const double last = (most + 1.0) * half + kRoom;
    if (!(first <= side_ && last >= 0.0)) return {0, -1};
    const auto cell = [&](double place) { return static_cast<int>(std::clamp(place, 0.0, side_ - 1.0)); };
    return {cell(first), cell(last)};
  }

  int side_ = 0;
};

}  // namespace firstlight::render
