#include "render/texture/pigment.h"

#include "render/texture/default_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace firstlight::render {
namespace {

/// A filter or transmit below this lets no light through. [POV-Ray 3.7]
constexpr double kOpaqueBelow = 1e-10;

/// POV-Ray keeps map positions in single precision, and computes with them in double.
double stored(double number) { return static_cast<float>(number); }

/// a + t (b - a), every step rounded to single precision as POV-Ray's colours are.
float blend(float a, float b, double t) { return a + static_cast<float>((b - a) * t); }

FilteredColor blend(const FilteredColor& a, const FilteredColor& b, double t) {
  return {{blend(a.rgb.x, b.rgb.x, t), blend(a.rgb.y, b.rgb.y, t), blend(a.rgb.z, b.rgb.z, t)},
          blend(a.filter, b.filter, t),
          blend(a.transmit, b.transmit, t)};
}

/// The colour at `value`: the last entry from its position on, else blended between the first entry that is not below
/// the value and the one before it. Of several entries at one position the first ends the range below, the last
/// begins the range above. Maps are short and need not be sorted, so they are searched from the front.
FilteredColor look_up(const ColorMap& map, double value) {
  if (value >= stored(map.back().position)) return map.back().color;
  std::size_t above = 0;
  while (stored(map[above].position) < value) ++above;
  const double end = stored(map[above].position);
  if (above == 0 || end == value) return map[above].color;
  const double begin = stored(map[above - 1].position);
  return blend(map[above - 1].color, map[above].color, (value - begin) / (end - begin));
}

bool lets_light_through(const FilteredColor& color) {
  return std::abs(color.filter) > kOpaqueBelow || std::abs(color.transmit) > kOpaqueBelow;
}

}  // namespace

void make_plain(Pigment& pigment) {
  // Most pigments are nothing else, so they share the pattern that says so.
  static const Shared<PigmentPattern> single_color(PigmentPattern{patterned(PatternKind::plain)});
  if (pigment.pattern.is_initial() || pigment.pattern.is_same(single_color)) {
    pigment.pattern = single_color;
    return;
  }
  Patterning& pattern = pigment.pattern.change();
  pattern.kind = PatternKind::plain;
  pattern.field = nullptr;
}

const ColorMap& map_of(const Pigment& pigment) {
  const PigmentPattern& pattern = pigment.pattern;
  return pattern.map.empty() ? default_map(pattern.kind) : pattern.map;
}

FilteredColor color_at(const Pigment& pigment, const Vec3& point) {
  if (!pigment.pattern->field) return pigment.color;
  return look_up(map_of(pigment), shaped(pigment.pattern->wave, value_at(pigment.pattern, point)));
}

bool lets_light_through(const Pigment& pigment) {
  if (!is_patterned(pigment.pattern->kind)) return lets_light_through(pigment.color);
  if (is_image(pigment.pattern->kind)) return true;
  if (pigment.pattern->pigments) return pigment.pattern->pigments->translucent;
  const ColorMap& map = map_of(pigment);
  return std::any_of(map.begin(), map.end(),
                     [](const ColorMapEntry& entry) { return lets_light_through(entry.color); });
}

void gather(const Pigment& pigment, FeatureUses& uses) {
  if (!is_patterned(pigment.pattern->kind)) return;
  gather(*pigment.pattern, uses);
  if (pigment.pattern->pigments) uses.add(pigment.pattern->pigments->unrendered);
}

}  // namespace firstlight::render
