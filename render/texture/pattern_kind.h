#pragma once

#include "render/feature/feature.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace firstlight::render {

/// The patterns of the scene language, one row a pattern in patterns.def. `none`: nothing has been said; `plain`: one
/// colour, the same everywhere.
enum class PatternKind : std::uint8_t {
  none,
  plain,
#define PATTERN(word, entries, maker) word,
#include "render/texture/patterns.def"
#undef PATTERN
};

/// The word of the scene language; empty for none and plain.
std::string_view spelling(PatternKind kind);
/// The feature that a use of the pattern asks for. Pre: above plain.
Feature feature_of(PatternKind kind);
/// Entries of a list pattern, whose values are the places of its entries: no wave, no blending. 0 for the others.
std::size_t list_size(PatternKind kind);
inline bool is_list(PatternKind kind) { return list_size(kind) > 0; }
/// Whether the pattern is an image that brings its own colours, bumps or materials.
bool is_image(PatternKind kind);
/// Whether there is anything that varies from place to place.
inline bool is_patterned(PatternKind kind) { return kind > PatternKind::plain; }

}  // namespace firstlight::render
