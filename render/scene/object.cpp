#include "render/scene/object.h"

#include <utility>

namespace firstlight::render {
namespace {

/// Objects that end level by level: those in the objects of a list wait until the list is gone.
struct HeldObjects {
  std::vector<Object> objects;

  explicit HeldObjects(std::vector<Object> list) : objects(std::move(list)) {}
  HeldObjects(const HeldObjects&) = delete;
  HeldObjects& operator=(const HeldObjects&) = delete;
  ~HeldObjects() {
    static thread_local std::vector<std::vector<Object>>* waiting = nullptr;
    if (waiting != nullptr) {
      if (!objects.empty()) waiting->push_back(std::move(objects));
      return;
    }
    std::vector<std::vector<Object>> lists;
    waiting = &lists;
    objects.clear();
    while (!lists.empty()) {
      const std::vector<Object> last = std::move(lists.back());
      lists.pop_back();
    }
    waiting = nullptr;
  }
};

bool is_empty(const ObjectList& list) { return !list || list->empty(); }

std::shared_ptr<const Object> placed(const std::shared_ptr<const Object>& object, const Transform& transform) {
  if (!object || transform.is_identity()) return object;
  auto moved = std::make_shared<Object>(*object);
  place(*moved, transform);
  return moved;
}

}  // namespace

ObjectList make_object_list(std::vector<Object> objects) {
  const auto held = std::make_shared<const HeldObjects>(std::move(objects));
  return {held, &held->objects};
}

bool is_plain_union(const Object& object) {
  return object.kind == Object::Kind::union_ && !object.turned && is_empty(object.extras->clipped_by) &&
         is_empty(object.extras->bounded_by);
}

void invert(Object& object) {
  object.inverted = !object.inverted;
  object.turned = true;
}

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
