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
/// A combination that is longer counts as one without bounds. [POV-Ray 3.7]
constexpr double kLongest = 1e6;
/// Added on all sides to the box of a triangle. [POV-Ray 3.7]
constexpr double kTrianglePadding = 1e-10;

bool are_made(const Objects& objects) { return !objects || std::all_of(objects->begin(), objects->end(), is_made); }

Box3 farthest_box() { return {Vec3(-kFarthest), Vec3(kFarthest)}; }

bool is_empty(const Box3& box) { return box.min.x > box.max.x || box.min.y > box.max.y || box.min.z > box.max.z; }

bool is_too_long(const Box3& box) {
  const Vec3 size = box.size();
  return std::max({size.x, size.y, size.z}) > kLongest;
}

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

bool is_plane(const Object& object) {
  return object.kind == Object::Kind::shape && dynamic_cast<const Plane*>(object.shape.get()) != nullptr;
}

Box3 box_of_shape(const Object& object, const Transform& here) {
  if (is_plane(object)) return farthest_box();
  Box3 box = placed_shape(object, here, false)->bounds();
  if (object.word == "triangle" || object.word == "smooth_triangle") {
    box.min -= Vec3(kTrianglePadding);
    box.max += Vec3(kTrianglePadding);
  }
  return box;
}

Box3 box_of(const Object& object, const Transform& placement);

/// Of a combination, in its own space. `inverse` does not change it.
Box3 box_of_members(const Object& object) {
  if (!object.children) return farthest_box();
  const bool intersects = object.kind == Object::Kind::intersection;
  Box3 box = farthest_box();
  if (!intersects) box.makeEmpty();
  for (const Object& member : *object.children) {
    if (!intersects) {
      box.extendBy(box_of(member, Transform()));
    } else if (is_plane(member)) {
      const ShapePtr shape = placed_shape(member, member.placement, member.inverted);
      box = common(box, box_of_half_space(dynamic_cast<const Plane&>(*shape)));
    } else if (!member.inverted) {
      box = common(box, box_of(member, Transform()));
    }
  }
  return is_empty(box) || is_too_long(stored(box)) ? farthest_box() : stored(box);
}

/// The box of a shape is that of where it is at last; the box of a combination moves as a box, and grows with each turn.
Box3 box_of(const Object& object, const Transform& placement) {
  if (object.kind == Object::Kind::light) return farthest_box();
  const Transform here = object.placement.then(placement);
  Box3 box = object.kind == Object::Kind::shape ? box_of_shape(object, here)
                                                : placement.box(stored(object.placement.box(box_of_members(object))));
  for (const Objects* cutting : {&clips_of(object), &bounds_of(object)}) {
    if (!*cutting) continue;
    for (const Object& cut : **cutting) {
      if (cut.inverted) continue;
      const Box3 both = common(box, box_of(cut, here));
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

Box3 extent(const Object& object) { return box_of(object, Transform()); }

}  // namespace firstlight::render
