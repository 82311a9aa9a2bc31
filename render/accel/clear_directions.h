#pragma once

#include "render/accel/leaves.h"
#include "render/light/light.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// The directions from each light in which nothing is seen that casts a shadow, but for planes: a feeler from there
/// needs no tree, and need not wait.
///
/// Cells    Directions are those of a cube around the light, in cells: of its faces +x, -x, +y, -y, +z, -z one after
/// the
///          other. On a face, places are the coordinates along the next two axes in turn, u and v, over the depth
///          along the face's axis, from -1 to 1; cells go by v, then by u. The lights' cubes follow each other.
/// Source   after Haines & Greenberg, The Light Buffer: A Shadow-Testing Accelerator, IEEE CG&A 6(9), 1986, whose cells
///          list what is seen through them.
/// Memory   at most 512 KiB, to stay near the processor.
/// Threads  Immutable after construction.
class ClearDirections {
 public:
  /// Pre: the lights are points.
  ClearDirections(const Leaves& leaves, std::span<const Light> lights);

  /// False where no direction can be told to be clear.
  bool known() const { return side_ > 0; }
  /// Cells along an edge of a cube.
  int side() const { return side_; }
  std::size_t cells_of_cube() const { return 6 * static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_); }
  /// Bit c % 32 of word c / 32: something may be seen through cell c.
  std::span<const std::uint32_t> words() const { return words_; }

 private:
  /// Marks what is seen of the tree below a node.
  void mark_children(const Leaves& leaves, std::size_t node, std::size_t cube, const Vec3& light);
  void mark(const FloatBox& box, std::size_t cube, const Vec3& light);

  int side_ = 0;
  std::vector<std::uint32_t> words_;
};

// The body of Accel::clear(), for the best instruction set that the machine has. Pre: directions.known().
void find_clear(const Leaves& leaves, const ClearDirections& directions, const Columns3<double>& points,
                std::size_t count, std::size_t first, std::span<const Light> lights, double gap, std::uint64_t* clear);

}  // namespace firstlight::render
