#pragma once

#include <array>
#include <cstdint>

namespace firstlight::render {

/// Tables of the original noise: a permutation of the lattice's points, and the coefficients of the linear functions
/// that are blended between them.
struct LatticeTables {
  static constexpr unsigned kPoints = 4096;
  /// Maps a point along x, then the result `xor` the one along y; twice in a row, for a point's neighbour may be one
  /// too far.
  std::array<std::uint16_t, 2 * kPoints> permutation{};
  /// The same for the last step, along z: where the coefficients begin.
  std::array<std::uint8_t, 2 * kPoints> entry{};
  std::array<double, 267> coefficients{};

  static const LatticeTables& get();

 private:
  LatticeTables();
};

/// Gradients on the unit sphere for the noise of generator 3. [K. Perlin's noise]
struct GradientTables {
  static constexpr unsigned kSize = 2048;
  std::array<std::uint16_t, 2 * (kSize + 1)> permutation{};
  std::array<std::array<double, 4>, 2 * (kSize + 1)> gradients{};  ///< x, y, z, 0

  static const GradientTables& get();

 private:
  GradientTables();
};

}  // namespace firstlight::render
