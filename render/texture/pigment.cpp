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

bool is_of_uv(PatternKind kind) { return kind == PatternKind::uv_mapping; }
bool is_of_surface(PatternKind kind) {
  return kind == PatternKind::uv_mapping || kind == PatternKind::slope || kind == PatternKind::aoi;
}

using KindTest = bool (*)(PatternKind);
bool any_kind(const Pigment& pigment, KindTest is);

/// Whether the pattern is of such a kind, or a part of a pigment that it asks.
bool any_kind(const Patterning& patterning, KindTest is) {
  if (is(patterning.kind)) return true;
  const auto* parameters = std::get_if<PigmentParameters>(&patterning.parameters);
  return parameters != nullptr && parameters->pigment && any_kind(*parameters->pigment, is);
}

bool any_kind(const Pigment& pigment, KindTest is) {
  const PigmentPattern& pattern = pigment.pattern;
  const auto is_one = [&](const MapEntry<Pigment>& entry) { return any_kind(entry.value, is); };
  return any_kind(static_cast<const Patterning&>(pattern), is) ||
         (pattern.pigments && std::ranges::any_of(pattern.pigments->entries, is_one));
}

}  // namespace

const FilteredColor* even_color(const Pigment& pigment, bool quick_colors) {
  const std::optional<FilteredColor>& quick = pigment.pattern->quick_color;
  if (quick_colors && quick && quick->rgb.x != -1.0f && quick->rgb.y != -1.0f && quick->rgb.z != -1.0f) return &*quick;
  return is_patterned(pigment.pattern->kind) ? nullptr : &pigment.color;
}

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
  return pattern.map.empty() ? default_map(pattern) : pattern.map;
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

bool goes_by_uv(const Pigment& pigment) { return any_kind(pigment, is_of_uv); }
bool goes_by_uv(const Patterning& patterning) { return any_kind(patterning, is_of_uv); }
bool goes_by_surface(const Pigment& pigment) { return any_kind(pigment, is_of_surface); }
bool goes_by_surface(const Patterning& patterning) { return any_kind(patterning, is_of_surface); }

void gather(const Pigment& pigment, FeatureUses& uses) {
  if (!is_patterned(pigment.pattern->kind)) return;
  gather(*pigment.pattern, uses);
  if (pigment.pattern->pigments) uses.add(pigment.pattern->pigments->unrendered);
}

}  // namespace firstlight::render
