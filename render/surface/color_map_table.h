#pragma once

#include "render/surface/color_columns.h"
#include "render/texture/pigment.h"

#include <cstddef>
#include <vector>

namespace firstlight::render {

/// A map of colours ready to be asked for those of many places.
///
/// Source   POV-Ray 3.7: places are found as by place_in_map(), and colours between entries are a + t (b - a), every step
///          rounded to single precision.
/// Memory   200 bytes an entry.
class ColorMapTable {
 public:
  /// A table of no map, not to be asked.
  ColorMapTable() = default;
  /// Pre: the map has entries.
  explicit ColorMapTable(const ColorMap& map);

  /// The colours of the first `count` places.
  void colors(const Column<double>& places, std::size_t count, ColorColumns& colors) const;

 private:
  std::vector<double> positions_;
  /// Row i leads from the entry before i to entry i, and row (entries + i) is entry i itself: the channels' first colours
  /// and their steps in turn, then the place where the row begins and its length.
  std::vector<double> rows_;
};

}  // namespace firstlight::render
