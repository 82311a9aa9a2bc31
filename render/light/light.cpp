#include "render/light/light.h"

namespace firstlight::render {

Light placed(const Light& light, const Transform& transform) {
  Light moved = light;
  moved.position = transform.point(light.position);
  moved.point_at = transform.point(light.point_at);
  if (moved.area) {
    moved.area->axis1 = transform.direction(moved.area->axis1);
    moved.area->axis2 = transform.direction(moved.area->axis2);
  }
  return moved;
}

}  // namespace firstlight::render
