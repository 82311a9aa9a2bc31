#include "render/texture/interior.h"

#include <algorithm>

namespace firstlight::render {

void move(Shared<Interior>& interior, const Transform& transform) {
  if (interior->media.empty() || transform.is_identity()) return;
  for (Media& media : interior.change().media) move(media, transform);
}

Shared<Interior> moved(Shared<Interior> interior, const Transform& transform) {
  move(interior, transform);
  return interior;
}

void gather(const Interior& interior, FeatureUses& uses) {
  for (const FeatureUse& use : interior.unrendered.list()) {
    const bool nothing = use.feature == Feature::caustics && interior.caustics == 0.0;
    if (!nothing) uses.add(use);
  }
  for (const Media& media : interior.media) gather(media, uses);
}

std::uint32_t depth_of(const Interior& interior) {
  std::uint32_t depth = 0;
  for (const Media& media : interior.media) {
    for (const Density& density : media.densities) depth = std::max(depth, density.pattern.depth);
  }
  return depth;
}

}  // namespace firstlight::render
