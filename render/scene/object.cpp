#include "render/scene/object.h"

namespace firstlight::render {
namespace {

std::shared_ptr<const Object> placed(const std::shared_ptr<const Object>& object, const Transform& transform) {
  if (!object || transform.is_identity()) return object;
  auto moved = std::make_shared<Object>(*object);
  place(*moved, transform);
  return moved;
}

}  // namespace

void place(Object& object, const Transform& transform) {
  object.placement = object.placement.then(transform);
  if (object.texture) object.texture_placement = object.texture_placement.then(transform);
  if (transform.is_identity()) return;
  if (object.cramped && object.kind != Object::Kind::shape) object.extras.change().box_steps.emplace_back(transform);
  if (object.extras.is_initial()) return;
  if (!object.extras->interior && !object.extras->interior_texture) return;
  ObjectExtras& extras = object.extras.change();
  if (extras.interior) move(*extras.interior, transform);
  if (extras.interior_texture) extras.interior_texture_placement = extras.interior_texture_placement.then(transform);
}

void finish_box(Object& object) {
  if (object.kind == Object::Kind::shape || (!object.extras->bounded_by && !object.extras->clipped_by)) return;
  object.extras.change().box_steps.emplace_back(std::nullopt);
}

Light placed_with_objects(const Light& light, const Transform& transform) {
  Light moved = placed(light, transform);
  moved.looks_like = placed(light.looks_like, transform);
  moved.projected_through = placed(light.projected_through, transform);
  return moved;
}

}  // namespace firstlight::render
