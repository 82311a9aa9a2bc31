#include "priority/object_scheme.h"
#include "priority/schemes.h"

#include <algorithm>

namespace firstlight::priority {

/// Rays that left simple objects first: those made of few shapes, counted in powers of two.
/// Source   Yagel & Meeker 1997, section 4, further criteria: object complexity.
SchemePtr make_complexity(const SchemeInput& input, SchemeText*) {
  constexpr std::uint8_t kMost = 31;
  std::vector<Key> keys;
  keys.reserve(input.scene.objects.size());
  for (const render::ObjectGroup& group : input.scene.objects) {
    keys.push_back(Key{kMost} - std::min(group.complexity, kMost));
  }
  return std::make_shared<ObjectScheme>(std::move(keys), Key{kMost} + 1);
}

}  // namespace firstlight::priority
