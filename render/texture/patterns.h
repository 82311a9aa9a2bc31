#pragma once

#include "render/texture/pattern.h"
#include "render/texture/pattern_kind.h"
#include "render/texture/pattern_parameters.h"
#include "render/texture/warp.h"

#include <memory>
#include <optional>

namespace firstlight::render {

using PatternPtr = std::shared_ptr<const Pattern>;

/// The scene's settings for all patterns.
struct PatternWorld {
  int noise_generator = 2;    ///< 1 to 3, of patterns that choose none
  int number_of_waves = 10;   ///< of `waves` and `ripples`
  bool quick_colors = false;  ///< pigments that have one are their quick colour
};

/// The parameters and settings that a pattern is made from.
struct PatternRequest {
  const PatternParameters& parameters;
  int noise_generator;
  const PatternWorld& world;
  const std::optional<Turbulence>& turbulence;  ///< the word outside `warp`: a few patterns have their own use of it
  Wave wave = {};                               ///< the same

  template <class Parameters>
  const Parameters& get() const {
    return std::get<Parameters>(parameters);
  }
};

/// The makers, one a row of patterns.def, each beside its formula; values are POV-Ray 3.7's.
namespace pattern {
#define PATTERN(word, entries, maker) PatternPtr maker(const PatternRequest& request);
#include "render/texture/patterns.def"
#undef PATTERN
}  // namespace pattern

/// The evaluator of a pattern; null for those that are no scalar fields.
PatternPtr make_pattern(PatternKind kind, const PatternRequest& request);

/// Whether the word `turbulence` moves the points at which the pattern is asked; a few put it to a use of their own.
bool is_moved_by_turbulence(PatternKind kind);

}  // namespace firstlight::render
