#pragma once

#include "render/feature/feature.h"
#include "render/texture/pattern.h"
#include "render/texture/pattern_kind.h"
#include "render/texture/pattern_parameters.h"
#include "render/texture/warp.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace firstlight::render {

/// How a pattern's value becomes a place in the map. [POV-Ray 3.7 manual, "Wave Forms"]
enum class WaveForm { ramp, triangle, sine, scallop, cubic, poly };

struct Wave {
  WaveForm form = WaveForm::ramp;
  double exponent = 1.0;  ///< of poly_wave
  double frequency = 1.0;
  double phase = 0.0;
};

/// A pattern with all that shapes its values, from the point in space to the place in a map. What the places mean is
/// the map's part: colours, pigments, normals, textures, densities.
struct Patterning {
  PatternKind kind = PatternKind::none;
  PatternParameters parameters = {};
  std::shared_ptr<const Pattern> field = {};  ///< evaluates kind and parameters; null where that is not rendered
  Wave wave = {};
  Warps warps = {};
  int noise_generator = 0;       ///< 1 to 3; 0: the scene's
  bool keeps_bump_size = false;  ///< no_bump_scale; of normals
  std::uint32_t depth = 0;       ///< levels of descriptions below, in maps and parameters
  FeatureUses unrendered = {};   ///< of kind and parameters
};

/// The pattern alone, at its defaults otherwise.
Patterning patterned(PatternKind kind, PatternParameters parameters = {});

/// The evaluator of a pattern; null for those that cannot be rendered.
std::shared_ptr<const Pattern> make_pattern(PatternKind kind, const PatternParameters& parameters);

/// The pattern's bare value at `point` of the space that it is placed in. Pre: field.
double value_at(const Patterning& patterning, const Vec3& point);
/// The place in the map for a bare value.
double shaped(const Wave& wave, double value);

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
