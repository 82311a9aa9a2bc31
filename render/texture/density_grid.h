#pragma once

#include "render/math/vec.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace firstlight::render {

/// Densities at the points of a grid over the unit cube, from a .df3 file: three numbers of 16 bits, the grid's size along
/// x, y and z; then the densities, x fastest, each of 8, 16 or 32 bits as the file's length has it; all with the highest
/// byte first. [POV-Ray 3.7 manual, "Density File"]
///
/// Memory   What the file takes; at most kMostBytes.
/// Threads  Immutable.
class DensityGrid {
 public:
  static constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;

  /// Null: `error` says in plain words why.
  static std::shared_ptr<const DensityGrid> read(const std::string& path, std::string& error);

  /// From 0 to 1, 0 outside of the cube. `interpolation`: its last digit 0: of the grid's cell, 1: trilinear, else
  /// tricubic.
  double value(const Vec3& point, int interpolation) const;

 private:
  using Cell = std::array<std::size_t, 3>;

  DensityGrid() = default;
  double at(std::size_t x, std::size_t y, std::size_t z) const;
  double trilinear(const Vec3& place) const;
  double tricubic(const Vec3& place) const;

  Cell size_{};
  std::size_t bytes_ = 1;  ///< of a density
  std::vector<std::uint8_t> densities_;
};

}  // namespace firstlight::render
