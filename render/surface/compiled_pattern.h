#pragma once

#include "render/math/single.h"
#include "render/texture/image_map.h"
#include "render/texture/patterning.h"
#include "render/texture/patterns.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace firstlight::render {

class CompiledPigment;  // render/surface/compiled_pigment.h, which stands on this

/// A pattern ready to be asked, from points of the space that it is placed in to places in its map.
///
/// Threads  Immutable. The Patterning must outlive it.
class CompiledPattern {
 public:
  CompiledPattern(const Patterning& source, const PatternWorld& world);

  const Patterning& source() const { return *source_; }
  /// Null where the pattern is no field of numbers by itself.
  const Pattern* field() const { return field_.get(); }

  /// Whether it is one of numbers at all: places() can be asked.
  bool has_places() const { return field_ != nullptr || pigment_ != nullptr; }
  /// The picture of an image_map or a material_map; null for all others.
  const ImageMap* image() const { return image_.get(); }

  /// The pattern's points for those of `points`.
  void to_pattern(const SurfacePoints& points, Columns3<double>& there) const;
  /// Places in the map at points of the pattern's space. Pre: has_places().
  void places(const Columns3<double>& there, const SurfacePoints& points, Column<double>& places) const;

 private:
  void greys(const Columns3<double>& there, const SurfacePoints& points, Column<double>& values) const;

  const Patterning* source_;
  PatternPtr field_;
  std::shared_ptr<const ImageMap> image_;
  std::shared_ptr<const CompiledPigment> pigment_;  ///< of pigment_pattern
  bool moved_by_turbulence_;
};

/// Where a value lies in a map: on an entry, or between two.
struct MapPlace {
  std::uint32_t below = 0;
  std::uint32_t above = 0;  ///< the same as `below`: the value is that of one entry
  double fraction = 0.0;    ///< from the one below to the one above
};

/// The last entry from its position on, else what lies between the first entry that is not below the value and the one
/// before it. Of several entries at one position the first ends the range below, the last begins the range above. Maps
/// are short and need not be sorted, so they are searched from the front. [POV-Ray 3.7]
/// `position(i)`: that of entry i. Pre: count > 0.
template <class Position>
MapPlace place_in_map(double value, std::uint32_t count, const Position& position) {
  if (value >= position(count - 1)) return {count - 1, count - 1, 0.0};
  std::uint32_t above = 0;
  while (position(above) < value) ++above;
  const double end = position(above);
  if (above == 0 || end == value) return {above, above, 0.0};
  const double begin = position(above - 1);
  return {above - 1, above, (value - begin) / (end - begin)};
}

/// Positions of maps are kept in single precision, and computed with in double. [POV-Ray 3.7]
inline double stored_position(double position) { return in_single(position); }

/// Calls visit(entry, lanes) for each entry of a map that any of the places touches, in the map's order; `lanes` is a bit
/// for each of them.
template <class Visit>
void for_each_entry(std::uint32_t entries, std::size_t count, const std::array<MapPlace, kRaysAtOnce>& places,
                    const Visit& visit) {
  for (std::uint32_t entry = 0; entry < entries; ++entry) {
    std::uint64_t lanes = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (places[i].below == entry || places[i].above == entry) lanes |= std::uint64_t{1} << i;
    }
    if (lanes != 0) visit(entry, lanes);
  }
}

/// Those of `points` whose bit is set, in order, with `at` for the space that they are asked in.
void pick(const SurfacePoints& points, const Columns3<double>& at, std::uint64_t lanes, SurfacePoints& picked);
/// All of them at places of their surfaces' own coordinates, (u, v, 0).
void to_own_coordinates(const SurfacePoints& points, SurfacePoints& there);

}  // namespace firstlight::render
