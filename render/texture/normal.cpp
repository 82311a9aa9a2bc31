#include "render/texture/normal.h"

namespace firstlight::render {

void gather(const Normal& normal, FeatureUses& uses) {
  gather(normal.pattern, uses);
  if (normal.slopes) uses.add(normal.slopes->unrendered);
  if (normal.normals) uses.add(normal.normals->unrendered);
}

}  // namespace firstlight::render
