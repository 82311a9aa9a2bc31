#pragma once

#include "render/accel/accel.h"
#include "render/accel/slab_tree.h"
#include "render/scene/scene.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace firstlight::render {

/// Decides which of several things that lie in one place is seen.
///
/// The first that is asked stays, if others are met at the same depth: so the order in which a ray asks solids is seen.
/// It also counts where depths differ by their last bits alone, because what is entered behind the nearest crossing is
/// not asked any more, and boxes are in single precision.
///
/// Source   POV-Ray 3.7: solids are asked in the order in which the ray enters their boxes, by a heap [Kay and Kajiya,
///          Ray Tracing Complex Scenes, 1986] over a SlabTree; in the order of the scene text where there are fewer than
///          three objects and lights. The heap is kept to the last detail too: boxes are often entered at equal depths.
/// Cost     Nothing until the first ray is in doubt, then a SlabTree of the scene.
/// Threads  Any thread may ask.
/// Ends     As Accel does, while an Interrupt lives.
class TieOrder {
 public:
  /// Pre: `scene` outlives it, unchanged.
  explicit TieOrder(const Scene& scene) : scene_(scene) {}

  /// Depths in doubt differ by at most this part of the nearer.
  static constexpr double kDoubt = 0x1p-24;

  /// Finds what is seen along ray i.
  Hit seen(const RayBlock& rays, std::size_t i) const;

 private:
  class Search;
  /// All that is made when the first ray is in doubt.
  struct Planted {
    SlabTree tree;
    std::vector<Box3> boxes;  ///< of the solids
  };

  const Planted& planted() const;

  const Scene& scene_;
  mutable std::mutex planting_;
  mutable std::unique_ptr<const Planted> planted_;
  mutable std::atomic<const Planted*> ready_ = nullptr;
};

}  // namespace firstlight::render
