#pragma once

#include "render/accel/ray_block.h"
#include "render/math/vec.h"
#include "render/scene/scene.h"
#include "render/shape/shape.h"

#include <array>
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
struct Hit : Crossing {
  std::uint32_t solid = kNoIndex;

  Hit() { part = kNoIndex; }
  Hit(const Crossing& crossing, std::uint32_t of_solid) : Crossing(crossing), solid(of_solid) {}
};

/// POV-Ray 3.7: a feeler ignores what is closer than this to either of its ends, in scene units.
constexpr double kShadowGap = 1e-3;

/// Where feelers begin: on surfaces.
struct FeelerStarts {
  const Columns3<double>& points;
  const Columns3<double>& normals;
  std::size_t count = 0;         ///< at most kRaysAtOnce
  bool from_both_sides = false;  ///< false: nobody asks about feelers that lead against the normal
};

/// The feelers to one light whose end is known, a bit each. A feeler in neither set has to be traced.
struct Foreseen {
  std::uint64_t clear = 0;    ///< meets nothing that casts a shadow
  std::uint64_t blocked = 0;  ///< meets something opaque

  bool operator==(const Foreseen&) const = default;
};

/// Whether an Accel foresees what it can of feelers, or nothing, so that each is traced as in the paper. The pictures
/// differ by roundings: light that nothing takes back is added as it is, not as feelers hold it.
enum class Foresight { some, none };

/// Finds what rays meet in a frozen scene.
///
/// Order    The answer to a query depends on the scene and the query alone: not on the other queries of a block, the
///          traversal, or the machine's vector width. Of solids met at one depth TieOrder says which is seen; inside
///          one solid the crossing that the solid reports last, as POV-Ray's stack of intersections has it.
/// Memory   Nothing is allocated per ray; each thread keeps a scratch list for solids with many crossings.
/// Ends     While an Interrupt lives, construction and answers end early when it is asked to, and are of no use then.
/// Threads  Immutable after construction.
class Accel {
 public:
  /// Pre: `scene` outlives the Accel, unchanged.
  explicit Accel(const Scene& scene, Foresight foresight = Foresight::some);
  ~Accel();
  Accel(Accel&&) noexcept;
  Accel& operator=(Accel&&) noexcept;

  /// hits[i] answers ray i of the block. Pre: hits has room for rays.size.
  void closest(const RayBlock& rays, std::span<Hit> hits) const;
  /// Bit i is set when any opaque part lies on ray i.
  std::uint64_t occluded(const RayBlock& rays) const;

  /// Foresees what feelers will meet, as far as that is quickly told: bit i of foreseen[l] is of the feeler from start
  /// i to lights[l]. `first` is the number of the first of the lights. Nothing is told of lights that are no points, as
  /// parallel ones. Pre: foreseen has room for lights.size.
  void foresee(const FeelerStarts& starts, std::size_t first, std::span<const Light> lights,
               std::span<Foreseen> foreseen) const;

  /// hits[i] answers queries[i]. Pre: equal sizes.
  void closest(std::span<const RayQuery> queries, std::span<Hit> hits) const;
  /// blocked[i] is 1 when any opaque part lies on queries[i], else 0. Pre: equal sizes.
  void occluded(std::span<const RayQuery> queries, std::span<std::uint8_t> blocked) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace firstlight::render
