#include "render/texture/pigment.h"

#include "render/texture/default_map.h"
#include "render/texture/image_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace firstlight::render {
namespace {

/// A filter or transmit below this lets no light through. [POV-Ray 3.7]
constexpr double kOpaqueBelow = 1e-10;

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
  pigment.pattern.change().kind = PatternKind::plain;
}

const ColorMap& map_of(const Pigment& pigment) {
  const PigmentPattern& pattern = pigment.pattern;
  return pattern.map.empty() ? default_map(pattern.kind) : pattern.map;
}

bool lets_light_through(const Pigment& pigment) {
  if (!is_patterned(pigment.pattern->kind)) return lets_light_through(pigment.color);
  if (const auto* const laid = std::get_if<ImageParameters>(&pigment.pattern->parameters);
      laid != nullptr && is_image(pigment.pattern->kind)) {
    return lets_light_through(laid->image);
  }
  if (pigment.pattern->pigments) return pigment.pattern->pigments->translucent;
  const ColorMap& map = map_of(pigment);
  return std::any_of(map.begin(), map.end(),
                     [](const ColorMapEntry& entry) { return lets_light_through(entry.color); });
}

bool goes_by_uv(const Pigment& pigment) {
  const PigmentPattern& pattern = pigment.pattern;
  const auto goes = [](const MapEntry<Pigment>& entry) { return goes_by_uv(entry.value); };
  return goes_by_uv(static_cast<const Patterning&>(pattern)) ||
         (pattern.pigments && std::ranges::any_of(pattern.pigments->entries, goes));
}

bool goes_by_uv(const Patterning& patterning) {
  if (patterning.kind == PatternKind::uv_mapping) return true;
  const auto* parameters = std::get_if<PigmentParameters>(&patterning.parameters);
  return parameters != nullptr && parameters->pigment && goes_by_uv(*parameters->pigment);
}

void gather(const Pigment& pigment, FeatureUses& uses) {
  if (!is_patterned(pigment.pattern->kind)) return;
  gather(*pigment.pattern, uses);
  if (pigment.pattern->pigments) uses.add(pigment.pattern->pigments->unrendered);
}

}  // namespace firstlight::render
