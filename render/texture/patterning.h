#pragma once

#include "render/feature/feature.h"
#include "render/texture/pattern_kind.h"
#include "render/texture/pattern_parameters.h"
#include "render/texture/warp.h"
#include "render/texture/wave.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace firstlight::render {

/// A pattern with all that shapes its values, from the point in space to the place in a map. What the places mean is
/// the map's part: colours, pigments, normals, textures, densities.
struct Patterning {
  PatternKind kind = PatternKind::none;
  PatternParameters parameters = {};
  Wave wave = {};
  Warps warps = {};
  int noise_generator = 0;       ///< 1 to 3; 0: the scene's
  bool keeps_bump_size = false;  ///< no_bump_scale; of normals
  std::uint32_t depth = 0;       ///< levels of descriptions below, in maps and parameters
  FeatureUses unrendered = {};   ///< of kind and parameters
};

/// The pattern alone, at its defaults otherwise.
Patterning patterned(PatternKind kind, PatternParameters parameters = {});

/// Whether it goes by a surface's own coordinates, itself or by a pigment that it asks.
bool goes_by_uv(const Patterning& patterning);
/// Whether it goes by more than the point: by the surface's coordinates, or by how it lies to what is seen.
bool goes_by_surface(const Patterning& patterning);
/// Adds what the pattern itself asks for that cannot be rendered. Nothing for a single colour.
void gather(const Patterning& patterning, FeatureUses& uses);

/// One entry of a map: what holds at a place between 0 and 1.
template <class T>
struct MapEntry {
  double position = 0.0;
  T value;
};

/// A map, or the list of a list pattern, whose entries are descriptions themselves. Shared, immutable once shared.
template <class T>
struct BlendMap {
  std::vector<MapEntry<T>> entries = {};
  std::uint32_t depth = 0;      ///< levels of descriptions below its entries
  bool translucent = false;     ///< an entry lets light through; of pigments and textures
  FeatureUses unrendered = {};  ///< of the map and all that is in it
};

}  // namespace firstlight::render
