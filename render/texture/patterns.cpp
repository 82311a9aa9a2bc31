#include "render/texture/patterns.h"

#include <array>
#include <cstddef>

namespace firstlight::render {
namespace {

using Maker = PatternPtr (*)(const PatternRequest&);

constexpr Maker kMakers[] = {
#define PATTERN(word, entries, maker) pattern::maker,
#include "render/texture/patterns.def"
#undef PATTERN
};

}  // namespace

PatternPtr pattern::composed(const PatternRequest&) { return nullptr; }

PatternPtr make_pattern(PatternKind kind, const PatternRequest& request) {
  constexpr std::size_t kFirst = static_cast<std::size_t>(PatternKind::plain) + 1;
  return is_patterned(kind) ? kMakers[static_cast<std::size_t>(kind) - kFirst](request) : nullptr;
}

bool is_moved_by_turbulence(PatternKind kind) { return kind != PatternKind::marble && kind != PatternKind::wood; }

}  // namespace firstlight::render
