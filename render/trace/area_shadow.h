#pragma once

#include "render/light/area_grid.h"
#include "render/trace/shadow.h"

#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// Finds how much light passes from area lights: the mean over points of their grids, which is asked in finer and finer
/// rectangles where their corners differ.
///
/// Source   POV-Ray 3.7 manual, "Area Lights".
/// Order    The feelers of a block are worked on in waves, so that blocks of rays stay full: the corners of all grids,
///          then those of all quarters that are wanted, and so on. What is found for one does not depend on the others.
/// Cost     At most as many rays for a feeler as its light has points.
/// Threads  One a thread.
class AreaShadow {
 public:
  /// A feeler to scene.lights[light]. Pre: that has an area.
  struct Feeler {
    Vec3 origin;
    std::uint32_t light = 0;
    std::uint32_t medium = 0;  ///< that the origin is in
  };

  /// Pre: both outlive it.
  AreaShadow(const Scene& scene, Shadow& shadow);

  /// shares[i] is what passes of the light that feelers[i] leads to. Returns how many rays that took. Pre: equal sizes.
  std::uint64_t find(std::span<const Feeler> feelers, std::span<Rgb> shares);

 private:
  struct Grid {
    const Light* light;
    const AreaTable* table;
    AreaGrid places;
    Rgb arriving;             ///< its colour as it would come without shadows
    std::size_t first_point;  ///< into asked_ and shares_
    double sum[3];
  };
  struct Region {
    std::size_t grid;
    AreaRectangle rectangle;
    double weight;
  };
  std::uint64_t find_together(std::span<const Feeler> feelers, std::span<Rgb> shares);
  /// The number of a grid's point among those of the grid.
  static std::size_t number_of(const Grid& grid, int u, int v) {
    return static_cast<std::size_t>(u) * static_cast<std::size_t>(grid.light->area->size2) +
           static_cast<std::size_t>(v);
  }
  void ask_corners(std::span<const Feeler> feelers);
  void send();
  void look_at(const Region& region, int level);

  const Scene& scene_;
  Shadow& shadow_;
  std::vector<AreaTable> tables_;      ///< of the lights that have an area
  std::vector<std::size_t> table_of_;  ///< of each light, into tables_
  std::vector<Grid> grids_;
  // Facts of the points of all grids:
  std::vector<std::uint8_t> asked_;
  std::vector<Rgb> shares_;  ///< of those that were asked
  std::vector<Region> regions_;
  std::vector<Region> next_regions_;
  RayBlock rays_;
  Columns3<double> places_;  ///< where they lead
  std::uint64_t aimed_ = 0;  ///< bits of those that have a direction already
  std::array<std::uint32_t, kRaysAtOnce> media_{};
  std::array<std::uint32_t, kRaysAtOnce> lights_{};
  std::array<std::size_t, kRaysAtOnce> targets_{};  ///< into asked_ and shares_
  std::uint64_t ray_count_ = 0;
};

}  // namespace firstlight::render
