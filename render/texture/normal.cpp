#include "render/texture/normal.h"

#include <algorithm>

namespace firstlight::render {

bool goes_by_uv(const Normal& normal) {
  const auto goes = [](const MapEntry<Normal>& entry) { return goes_by_uv(entry.value); };
  return goes_by_uv(normal.pattern) ||
         (normal.normals && std::ranges::any_of(normal.normals->entries, goes));
}

void gather(const Normal& normal, FeatureUses& uses) {
  gather(normal.pattern, uses);
  if (normal.slopes) uses.add(normal.slopes->unrendered);
  if (normal.normals) uses.add(normal.normals->unrendered);
}

}  // namespace firstlight::render
