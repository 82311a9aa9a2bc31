#include "render/scene/region.h"

#include "render/scene/extent.h"
#include "render/scene/scene.h"
#include "render/scene/walk_members.h"

#include <utility>

namespace firstlight::render {
namespace {

bool is_empty(const ObjectList& list) { return !list || list->empty(); }

/// Makes the regions of a combination's members. Unions that are nested too deep for recursion become one.
std::vector<Solid> member_regions(const Object& whole, const Transform& to_world, bool inverted) {
  std::vector<Solid> result;
  if (!whole.children) return result;
  result.reserve(whole.children->size());
  const bool deep = whole.nesting > kMostDepth && whole.kind == Object::Kind::union_;
  const auto enter = [&](const Object& member, const Transform& around) {
    return deep && is_plain_union(member) ? std::optional(member.placement.then(around)) : std::nullopt;
  };
  walk_members(whole, to_world, enter, [&](const Object& member, const Transform& around) {
    if (std::optional<Solid> solid = region(member, around, inverted)) result.push_back(std::move(*solid));
  });
  return result;
}

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

const ObjectList& clips_of(const Object& object) {
  return object.extras->bounds_are_clips && is_empty(object.extras->clipped_by) ? object.extras->bounded_by
                                                                                : object.extras->clipped_by;
}

const ObjectList& bounds_of(const Object& object) {
  return object.extras->bounds_are_clips && is_empty(object.extras->bounded_by) ? object.extras->clipped_by
                                                                                : object.extras->bounded_by;
}

std::vector<Solid> regions(const ObjectList& objects, const Transform& to_world) {
  std::vector<Solid> result;
  if (!objects) return result;
  result.reserve(objects->size());
  for (const Object& object : *objects) {
    if (std::optional<Solid> solid = region(object, to_world, false)) result.push_back(std::move(*solid));
  }
  return result;
}

std::vector<Solid> bounding_regions(const ObjectList& objects, const Transform& to_world) {
  std::vector<Solid> result;
  if (!objects) return result;
  for (const Object& object : *objects) {
    std::optional<Solid> solid = region(object, to_world, false);
    if (!solid) continue;
    if (object.cramped) solid->set_extent(extent_of_cutter(object, to_world));
    result.push_back(std::move(*solid));
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
    solid.set_members(member_regions(object, here, complement));
  }
  solid.set_clips(regions(clips_of(object), here));
  solid.set_bounds(bounding_regions(bounds_of(object), here));
  solid.close();
  return solid;
}

}  // namespace firstlight::render
