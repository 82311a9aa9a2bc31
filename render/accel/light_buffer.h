#pragma once

#include "render/accel/cube_cells.h"
#include "render/accel/leaves.h"
#include "render/light/light.h"
#include "render/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// The view from each light in each direction, planes left out: by it most feelers are told to be clear or blocked, so
/// they need no tree, and need not wait.
///
/// Cells    Directions are the cells of a cube around the light, see CubeCells. Cells come in tiles; a tile through
///          which nothing is seen that casts a shadow has no cells of its own.
/// Cost     built in some 30 ns a cell and thing seen through it, and coarser where those would be many for the scene.
/// Source   after Haines & Greenberg, The Light Buffer: A Shadow-Testing Accelerator, IEEE CG&A 6(9), 1986, whose cells
///          list all that is seen through them.
/// Memory   at most some 10 MB, and the spheres that are seen.
/// Threads  Immutable after construction.
class LightBuffer {
 public:
  static constexpr int kTile = 8;  ///< cells along an edge of a tile
  static constexpr std::uint32_t kCellsOfTile = kTile * kTile;

  /// The things that cast shadows through a cell. Distances are from the light, with room for rounding.
  struct Cell {
    float first = FloatBox::kInfinity;   ///< nothing is nearer
    float second = FloatBox::kInfinity;  ///< nothing but `sphere` is nearer
    float dark = FloatBox::kInfinity;    ///< all points beyond are in the shadow of one sphere
    std::uint32_t sphere = kNoIndex;     ///< into spheres(): the nearest thing, if it is an opaque one
  };
  /// Everything beside the cells that may be met, seen from a light.
  struct Around {
    double limit = FloatBox::kInfinity;  ///< of the distances at which anything can be told to be clear
    std::vector<PlaneLeaf> walls;        ///< of boxes that the light is in
  };
  /// Points further away than so many times Cell::dark are too far for roundings not to matter.
  static constexpr double kFarthestDark = 1000.0;
  struct RoundBlocker {
    Vec3 center;
    double radius_squared;
  };

  /// Lights that are no points have cubes in which nothing is marked: nobody may ask about them.
  LightBuffer(const Leaves& leaves, std::span<const Light> lights);

  /// False where nothing can be told.
  bool known() const { return !tiles_.empty(); }
  const CubeCells& cube() const { return cube_; }
  /// Along an edge of a cube.
  std::size_t tiles_along() const { return static_cast<std::size_t>(cube_.side() / kTile); }
  std::size_t tiles_of_cube() const { return 6 * tiles_along() * tiles_along(); }
  /// By light, face, v and u: 0 where nothing is seen, else n for the cells from kCellsOfTile * (n - 1) on, by v and u.
  std::span<const std::uint32_t> tiles() const { return tiles_; }
  /// Bit t % 32 of word t / 32: tile t has cells.
  std::span<const std::uint32_t> open_tiles() const { return open_tiles_; }
  std::span<const Cell> cells() const { return cells_; }
  std::span<const RoundBlocker> spheres() const { return spheres_; }
  const Around& around(std::size_t light) const { return around_[light]; }

 private:
  class Builder;
  /// The finest cube of which all is soon marked.
  int side_for(const Leaves& leaves, std::span<const Light> lights);
  void mark_open_tiles();
  void keep_spheres(const Leaves& leaves);

  CubeCells cube_;
  std::vector<std::uint32_t> tiles_;
  std::vector<std::uint32_t> open_tiles_;
  std::vector<Cell> cells_;
  std::vector<RoundBlocker> spheres_;
  std::vector<Around> around_;
};

// The body of Accel::foresee(), for the best instruction set that the machine has. Pre: buffer.known().
void find_foreseen(const Leaves& leaves, const LightBuffer& buffer, const FeelerStarts& starts, std::size_t first,
                   std::span<const Light> lights, std::span<Foreseen> foreseen);

}  // namespace firstlight::render
