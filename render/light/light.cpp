#include "render/light/light.h"

namespace firstlight::render {

Light placed(const Light& light, const Transform& transform) {
  Light moved = light;
  moved.position = transform.point(light.position);
  return moved;
}

}  // namespace firstlight::render
