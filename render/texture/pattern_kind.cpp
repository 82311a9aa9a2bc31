#include "render/texture/pattern_kind.h"

#include <array>

namespace firstlight::render {
namespace {

struct Row {
  std::string_view word;
  Feature feature;
  std::size_t entries;
};

constexpr auto kRows = std::to_array<Row>({
#define PATTERN(word, entries, maker) {#word, Feature::pattern_##word, entries},
#include "render/texture/patterns.def"
#undef PATTERN
});

constexpr std::size_t kFirst = static_cast<std::size_t>(PatternKind::plain) + 1;

const Row& row_of(PatternKind kind) { return kRows[static_cast<std::size_t>(kind) - kFirst]; }

}  // namespace

std::string_view spelling(PatternKind kind) { return is_patterned(kind) ? row_of(kind).word : std::string_view(); }
Feature feature_of(PatternKind kind) { return row_of(kind).feature; }
std::size_t list_size(PatternKind kind) { return is_patterned(kind) ? row_of(kind).entries : 0; }

bool is_image(PatternKind kind) {
  return kind == PatternKind::image_map || kind == PatternKind::bump_map || kind == PatternKind::material_map;
}

}  // namespace firstlight::render
