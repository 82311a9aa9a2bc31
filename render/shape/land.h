#pragma once

#include "render/math/transform.h"
#include "render/shape/height_field.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace firstlight::render {

/// The land of a height field, in a space where points of the grid are 1 apart and heights are as they are given.
class Land {
 public:
  static constexpr double kFull = 65536.0;
  static constexpr double kRoom = 0.001;  ///< POV-Ray's box is so much higher than the land, in its own space
  static constexpr int kShrink = 4;       ///< a block has so many of the level below along each side

  /// The least and the greatest height in a block of the grid.
  struct Span {
    std::uint16_t low;
    std::uint16_t high;
  };
  /// Blocks of one size side by side, along x, then along z. Those of level 0 are the cells.
  struct Level {
    int columns;
    int rows;
    std::vector<Span> spans;

    std::size_t index(int x, int z) const {
      return static_cast<std::size_t>(z) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
    }
    const Span& at(int x, int z) const { return spans[index(x, z)]; }
  };

  explicit Land(HeightFieldParameters parameters);

  bool is_smooth() const { return given_.smooth; }
  Box3 box() const { return Box3(Vec3(0.0, low_, 0.0), Vec3(given_.columns - 1.0, high_, given_.rows - 1.0)); }
  Transform to_unit() const;
  /// The last has one block.
  const std::vector<Level>& levels() const { return levels_; }
  double height(int x, int z) const { return given_.heights[index(x, z)]; }
  bool holds(const Vec3& p) const;

  /// Faces are the two triangles of each cell, the one about its corner with the greater coordinates behind the other.
  std::uint32_t face(int x, int z, bool is_far) const {
    return 2 * static_cast<std::uint32_t>(z * (given_.columns - 1) + x) + (is_far ? 1 : 0);
  }
  Vec3 flat_normal(std::uint32_t face) const;
  /// Calls take(normal, weight) for the corners of the cell around a point.
  template <class Take>
  void smooth_normals(const Vec3& p, const Take& take) const {
    const int x = cell_of(p.x, given_.columns - 1);
    const int z = cell_of(p.z, given_.rows - 1);
    const double u = p.x - x;
    const double v = p.z - z;
    take(Vec3(normals_[index(x, z)]), (1.0 - v) * (1.0 - u));
    take(Vec3(normals_[index(x + 1, z)]), (1.0 - v) * u);
    take(Vec3(normals_[index(x, z + 1)]), v * (1.0 - u));
    take(Vec3(normals_[index(x + 1, z + 1)]), v * u);
  }

 private:
  using Short3 = Imath::Vec3<short>;

  std::size_t index(int x, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(given_.columns) + static_cast<std::size_t>(x);
  }
  static int cell_of(double place, int count) {
    const int cell = static_cast<int>(place);
    return cell < 0 ? 0 : cell < count ? cell : count - 1;
  }
  void make_levels();
  void make_normals();

  HeightFieldParameters given_;
  double low_;
  double high_;
  std::vector<Level> levels_;
  std::vector<Short3> normals_;
};

}  // namespace firstlight::render
