#pragma once

#include "render/texture/pattern_parameters.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace firstlight::render {

/// How cells are joined to the tiles of one pavement.
///
/// Cells    `across` of a row, of `rows` rows, then all again: cell (i, j) is as (i + across, j) and as (i + skew, j + rows).
///          Squares have sides of 1. Triangles have too; in a row, those that stand and those that hang take turns, and the
///          standing triangle (i, j) has its left corner at (i / 2 + j / 2, j sqrt(3) / 2). Hexagons are six triangles.
/// Walls    a hexadecimal digit a cell, bits for the sides that are a tile's border: of squares upper, right, lower, left; of
///          triangles left, right, lower, of those that hang as if turned by half a turn.
struct PavementWalls {
  int sides;  ///< of what the tiles are made of: 3, 4 or 6
  int tiles;  ///< joined to one
  int across;
  int rows;
  int skew;
  std::string_view walls;
};

/// All of them. Those of equal sides and tiles stand together, in the order of their numbers in the scene language.
std::span<const PavementWalls> pavement_walls();

/// A plane that is paved with equal tiles. The values are 1 at a tile's border and 0 in its middle.
/// Source   POV-Ray 3.7's pattern of that name; manual, "Pavement".
/// Threads  Immutable.
class Pavement {
 public:
  /// Pre: there is such a pavement.
  explicit Pavement(const PavementParameters& parameters);

  double at(double x, double z) const { return grid_->sides == 4 ? in_square(x, z) : in_triangle(x, z); }

 private:
  /// Corners are numbered as the sides: of squares the corner behind a side clockwise (upper right for the upper one), of
  /// triangles the one that is opposite.
  struct Cell {
    std::uint8_t walls = 0;
    std::uint8_t concave = 0;  ///< bits of the corners at which the tile goes on around the end of a wall of others
    /// Bits, for triangles, of the walls behind whose end at a corner (the index) the tile turns with an obtuse angle.
    std::array<std::uint8_t, 3> obtuse{};
  };
  std::size_t index(int i, int j) const;
  Cell& cell(int i, int j) { return cells_[index(i, j)]; }
  const Cell& cell(int i, int j) const { return cells_[index(i, j)]; }
  bool has_wall(int i, int j, int side) const { return (cell(i, j).walls >> side & 1) != 0; }
  void look_around_square(int i, int j);
  void look_around_triangle(int i, int j);
  double in_square(double x, double z) const;
  double in_triangle(double x, double z) const;

  const PavementWalls* grid_;
  int exterior_;
  int interior_;
  int form_;
  std::vector<Cell> cells_;
};

}  // namespace firstlight::render
