#pragma once

#include "render/accel/ray_block.h"
#include "render/math/vec.h"
#include "render/scene/scene.h"

#include <cstdint>
#include <memory>
#include <span>

namespace firstlight::render {

/// A ray and the part of it that counts: crossings with min_depth < depth < max_depth.
struct RayQuery {
  Ray ray;
  double min_depth = 0.0;
  double max_depth = 0.0;
  std::uint8_t hidden_bit =
      0;  ///< kHiddenFromPrimary, ...Reflection or ...Shadow of the ray's kind; 0: sees everything
};

/// The nearest crossing of a ray. `part == kNoIndex`: nothing was met.
struct Hit {
  double depth = 0.0;
  std::uint32_t part = kNoIndex;
  std::uint32_t face = 0;
  const Shape* shape = nullptr;  ///< answers normal() for this crossing
  std::uint32_t solid = kNoIndex;
};

/// Finds what rays meet in a frozen scene.
///
/// Order    The answer to a query depends on the scene and the query alone: not on the other queries of a block, the
///          traversal, or the machine's vector width. Of crossings at exactly equal depth the lowest solid index wins;
///          inside one solid the crossing that the solid reports last, as POV-Ray's stack of intersections has it.
/// Memory   Nothing is allocated per ray; each thread keeps a scratch list for solids with many crossings.
/// Threads  Immutable after construction.
class Accel {
 public:
  /// Pre: `scene` outlives the Accel, unchanged.
  explicit Accel(const Scene& scene);
  ~Accel();
  Accel(Accel&&) noexcept;
  Accel& operator=(Accel&&) noexcept;

  /// hits[i] answers ray i of the block. Pre: hits has room for rays.size.
  void closest(const RayBlock& rays, std::span<Hit> hits) const;
  /// Bit i is set when any opaque part lies on ray i.
  std::uint64_t occluded(const RayBlock& rays) const;

  /// Which feelers certainly meet nothing that casts a shadow, as far as that is quickly told: bit i of clear[l] is set
  /// when that of points i to lights[l] does, which ignores what is closer than `gap` to either end. `first` is the
  /// number of the first of the lights. Pre: the lights are points; clear has room
  /// for lights.size; count is at most kRaysAtOnce.
  void clear(const Columns3<double>& points, std::size_t count, std::size_t first, std::span<const Light> lights,
             double gap, std::span<std::uint64_t> clear) const;

  /// hits[i] answers queries[i]. Pre: equal sizes.
  void closest(std::span<const RayQuery> queries, std::span<Hit> hits) const;
  /// blocked[i] is 1 when any opaque part lies on queries[i], else 0. Pre: equal sizes.
  void occluded(std::span<const RayQuery> queries, std::span<std::uint8_t> blocked) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace firstlight::render
