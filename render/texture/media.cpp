#include "render/texture/media.h"

namespace firstlight::render {

void move(Media& media, const Transform& transform) {
  for (Density& density : media.densities) density.pattern.warps.transform(transform);
}

void gather(const Density& density, FeatureUses& uses) {
  gather(density.pattern, uses);
  if (density.densities) uses.add(density.densities->unrendered);
}

void gather(const Media& media, FeatureUses& uses) {
  uses.add(media.unrendered);
  for (const Density& density : media.densities) gather(density, uses);
}

}  // namespace firstlight::render
