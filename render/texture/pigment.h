#pragma once

#include "render/feature/feature.h"
#include "render/math/color.h"
#include "render/math/shared.h"
#include "render/texture/patterning.h"

#include <memory>
#include <optional>
#include <vector>

namespace firstlight::render {

struct ColorMapEntry {
  double position = 0.0;
  FilteredColor color = {};
};

/// Entries in rising order of position; colours between them are interpolated, beyond them they stay. Of a list
/// pattern: its colours in order.
using ColorMap = std::vector<ColorMapEntry>;
using PigmentMap = BlendMap<Pigment>;

/// The parts of a pigment that is more than one colour.
struct PigmentPattern : Patterning {
  ColorMap map = {};                                ///< empty: the pattern's own, see map_of()
  std::shared_ptr<const PigmentMap> pigments = {};  ///< instead of `map`; with uv_mapping and average the only form
  std::optional<FilteredColor> quick_color = {};    ///< shown instead by pictures of low quality
};

/// Colour of a surface at a point: one colour, or a pattern through a map of colours or of pigments. Plain data.
struct Pigment {
  FilteredColor color = {};  ///< of PatternKind::plain; nothing said means black
  Shared<PigmentPattern> pattern = {};
};

/// The colour that the pigment has everywhere, its quick colour if those are shown; null: there is none. A quick colour
/// with a channel of -1 is none. [POV-Ray 3.7]
const FilteredColor* even_color(const Pigment& pigment, bool quick_colors);

/// Makes it one of a single colour, whatever pattern it had; `color` is the caller's to set.
void make_plain(Pigment& pigment);

/// The colours that show: the pigment's map, or what POV-Ray gives the pattern when there is none.
const ColorMap& map_of(const Pigment& pigment);

/// Whether the pigment lets light through anywhere.
bool lets_light_through(const Pigment& pigment);

/// Whether any part of it goes by a surface's own coordinates.
bool goes_by_uv(const Pigment& pigment);
/// Whether any part of it goes by more of a surface than the point.
bool goes_by_surface(const Pigment& pigment);
/// Adds what the pigment asks for that cannot be rendered.
void gather(const Pigment& pigment, FeatureUses& uses);

}  // namespace firstlight::render
