#include "render/scene/object.h"

namespace firstlight::render {

void place(Object& object, const Transform& transform) {
  object.placement = object.placement.then(transform);
  if (object.texture) object.texture_placement = object.texture_placement.then(transform);
  if (object.interior_texture) object.interior_texture_placement = object.interior_texture_placement.then(transform);
}

}  // namespace firstlight::render
