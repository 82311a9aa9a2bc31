#include "render/scene/region.h"

#include "render/scene/scene.h"

#include <utility>

namespace firstlight::render {
namespace {

bool is_empty(const std::shared_ptr<const std::vector<Object>>& list) { return !list || list->empty(); }

}  // namespace

Solid::Kind solid_kind(Object::Kind kind, bool inverted) {
  switch (kind) {
    case Object::Kind::union_:
      return inverted ? Solid::Kind::intersection : Solid::Kind::union_;
    case Object::Kind::merge:
      return inverted ? Solid::Kind::intersection : Solid::Kind::merge;
    case Object::Kind::intersection:
      return inverted ? Solid::Kind::merge : Solid::Kind::intersection;
    case Object::Kind::shape:
    case Object::Kind::light:
      break;
  }
  return Solid::Kind::shape;
}

const std::shared_ptr<const std::vector<Object>>& clips_of(const Object& object) {
  return object.bounds_are_clips && is_empty(object.clipped_by) ? object.bounded_by : object.clipped_by;
}

const std::shared_ptr<const std::vector<Object>>& bounds_of(const Object& object) {
  return object.bounds_are_clips && is_empty(object.bounded_by) ? object.clipped_by : object.bounded_by;
}

std::vector<Solid> regions(const std::shared_ptr<const std::vector<Object>>& objects, const Transform& to_world,
                           bool inverted) {
  std::vector<Solid> result;
  if (!objects) return result;
  result.reserve(objects->size());
  for (const Object& object : *objects) {
    if (std::optional<Solid> solid = region(object, to_world, inverted)) result.push_back(std::move(*solid));
  }
  return result;
}

ShapePtr placed_shape(const Object& object, const Transform& to_world, bool inverted) {
  ShapePtr shape = to_world.is_identity() ? object.shape : object.shape->placed(to_world);
  return inverted ? shape->inverted() : shape;
}

std::optional<Solid> region(const Object& object, const Transform& to_world, bool inverted) {
  if (object.kind == Object::Kind::light || (object.kind == Object::Kind::shape && !object.shape)) return std::nullopt;
  const Transform here = object.placement.then(to_world);
  const bool complement = inverted != object.inverted;
  Solid solid;
  solid.kind = solid_kind(object.kind, complement);
  solid.part = kNoIndex;
  if (object.kind == Object::Kind::shape) {
    solid.shape = placed_shape(object, here, complement);
  } else {
    solid.members = regions(object.children, here, complement);
  }
  solid.clips = regions(clips_of(object), here);
  solid.bounds = regions(bounds_of(object), here);
  solid.close();
  return solid;
}

}  // namespace firstlight::render
