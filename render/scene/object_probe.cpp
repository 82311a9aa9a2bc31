#include "render/scene/object_probe.h"

#include "render/scene/region.h"
#include "render/shape/plane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

using Objects = std::shared_ptr<const std::vector<Object>>;

/// Nearer crossings are taken for the surface that the ray begins on. [POV-Ray 3.7]
constexpr double kNearest = 1e-4;
/// Where the box of what has no bounds ends. [POV-Ray 3.7]
constexpr double kFarthest = 1e10;
/// Added on all sides to the box of a triangle. [POV-Ray 3.7]
constexpr double kTrianglePadding = 1e-10;

bool are_made(const Objects& objects) { return !objects || std::all_of(objects->begin(), objects->end(), is_made); }

Box3 farthest_box() { return {Vec3(-kFarthest), Vec3(kFarthest)}; }

bool is_empty(const Box3& box) { return box.min.x > box.max.x || box.min.y > box.max.y || box.min.z > box.max.z; }

Box3 common(const Box3& a, const Box3& b) {
  Box3 both;
  for (int axis = 0; axis < 3; ++axis) {
    both.min[axis] = std::max(a.min[axis], b.min[axis]);
    both.max[axis] = std::min(a.max[axis], b.max[axis]);
  }
  return both;
}

/// The box as POV-Ray keeps it: a corner and the lengths of the sides, in single precision.
Box3 stored(const Box3& box) {
  Box3 result;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = std::clamp(box.min[axis], -kFarthest, kFarthest);
    const double high = std::clamp(box.max[axis], -kFarthest, kFarthest);
    const auto corner = static_cast<float>(low);
    result.min[axis] = corner;
    result.max[axis] = corner + static_cast<float>(high - low);
  }
  return result;
}

Box3 box_of(const Object& object, const Transform& to_world, bool inverted);

/// What is below a plane, if the plane lies along two axes.
Box3 box_of_half_space(const Plane& plane) {
  constexpr double kAlmostOne = 1.0 - 1e-10;
  Box3 box = farthest_box();
  for (int axis = 0; axis < 3; ++axis) {
    const double along = plane.unit_normal()[axis];
    if (std::abs(along) > kAlmostOne) (along > 0.0 ? box.max : box.min)[axis] = -plane.offset() / along;
  }
  return box;
}

Box3 box_of_shape(const Object& object, const Transform& here, bool inverted, bool in_intersection) {
  const ShapePtr shape = placed_shape(object, here, inverted);
  if (const auto* plane = dynamic_cast<const Plane*>(shape.get())) {
    return in_intersection ? box_of_half_space(*plane) : farthest_box();
  }
  Box3 box = shape->bounds();
  if (object.word == "triangle" || object.word == "smooth_triangle") {
    box.min -= Vec3(kTrianglePadding);
    box.max += Vec3(kTrianglePadding);
  }
  return box;
}

bool is_plane(const Object& object) {
  return object.kind == Object::Kind::shape && dynamic_cast<const Plane*>(object.shape.get()) != nullptr;
}

/// Of a combination whose members stand in `here`.
Box3 box_of_members(const Object& object, const Transform& here, bool inverted) {
  if (!object.children) return farthest_box();
  const bool intersects = solid_kind(object.kind, inverted) == Solid::Kind::intersection;
  Box3 box = farthest_box();
  if (!intersects) box.makeEmpty();
  for (const Object& member : *object.children) {
    if (!intersects) {
      box.extendBy(box_of(member, here, inverted));
    } else if (is_plane(member)) {
      const bool complement = inverted != member.inverted;
      box = common(box, box_of_shape(member, member.placement.then(here), complement, true));
    } else if (inverted == member.inverted) {
      box = common(box, box_of(member, here, inverted));
    }
  }
  return is_empty(box) ? farthest_box() : box;
}

Box3 box_of(const Object& object, const Transform& to_world, bool inverted) {
  if (object.kind == Object::Kind::light) return farthest_box();
  const Transform here = object.placement.then(to_world);
  const bool complement = inverted != object.inverted;
  Box3 box = object.kind == Object::Kind::shape ? box_of_shape(object, here, complement, false)
                                                : box_of_members(object, here, complement);
  for (const Objects* cutting : {&clips_of(object), &bounds_of(object)}) {
    if (!*cutting) continue;
    for (const Object& cut : **cutting) {
      if (cut.inverted) continue;
      const Box3 both = common(box, box_of(cut, here, false));
      if (!is_empty(both)) box = both;
    }
  }
  return stored(box);
}

}  // namespace

bool is_made(const Object& object) {
  if (object.kind == Object::Kind::shape && !object.shape) return false;
  return are_made(object.children) && are_made(object.extras->clipped_by) && are_made(object.extras->bounded_by);
}

ObjectProbe::ObjectProbe(const Object& object) : complete_(is_made(object)) {
  std::optional<Solid> solid = region(object, Transform(), false);
  if (solid) solid_ = std::make_shared<const Solid>(std::move(*solid));
}

std::optional<ObjectProbe::Hit> ObjectProbe::trace(const Vec3& origin, const Vec3& direction) const {
  const double length = direction.length();
  if (!solid_ || !(length > 0.0)) return std::nullopt;
  const Ray ray{origin, direction * (1.0 / length)};
  std::vector<Crossing> crossings;
  solid_->crossings(ray, 0, crossings);
  const Crossing* first = nullptr;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Crossing& crossing : crossings) {
    if (crossing.depth < kNearest || !(crossing.depth < nearest)) continue;
    nearest = crossing.depth;
    first = &crossing;
  }
  if (first == nullptr) return std::nullopt;
  const Vec3 point = ray.at(first->depth);
  return Hit{point, first->shape->normal(point, *first)};
}

bool ObjectProbe::inside(const Vec3& point) const { return solid_ && solid_->inside(point); }

Box3 extent(const Object& object) { return box_of(object, Transform(), false); }

}  // namespace firstlight::render
