#include "priority/object_scheme.h"
#include "priority/schemes.h"

#include <array>

namespace firstlight::priority {
namespace {

// In the order of render::SurfaceKind.
constexpr std::array<std::string_view, 4> kWords{"plain", "glossy", "mirror", "clear"};

}  // namespace

/// By the property of the surface that a ray left, in the order that the user wants; else clear ones, mirrors, those
/// with highlights and plain ones.
/// Source   Yagel & Meeker 1997, section 4, further criteria: surface property.
SchemePtr make_surface(const SchemeInput& input, SchemeText* arguments) {
  const std::vector<std::uint32_t> ranks = arguments != nullptr ? read_ranks(*arguments, "a kind of surface", kWords).of
                                                                : std::vector<std::uint32_t>{3, 2, 1, 0};
  std::vector<Key> keys;
  keys.reserve(input.scene.objects.size());
  for (const render::ObjectGroup& group : input.scene.objects) {
    keys.push_back(static_cast<Key>(kWords.size() - 1) - ranks[static_cast<std::size_t>(group.surface)]);
  }
  return std::make_shared<ObjectScheme>(std::move(keys), static_cast<Key>(kWords.size()));
}

}  // namespace firstlight::priority
