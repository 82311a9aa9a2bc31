#include "render/scene/extent.h"

#include "render/math/bounds.h"
#include "render/scene/object.h"
#include "render/scene/region.h"
#include "render/shape/height_field.h"
#include "render/shape/plane.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace firstlight::render {
namespace {

/// Where the box of what has no bounds ends. [POV-Ray 3.7]
constexpr double kFarthest = 1e10;
/// In single precision, and after moves.
constexpr double kAlmostFarthest = 0.999e10;
/// A combination that is longer counts as one without bounds. [POV-Ray 3.7]
constexpr float kLongest = 1e6f;
/// A larger one is met by every ray. [POV-Ray 3.7]
constexpr float kUnboundedVolume = 2e10f;

Box3 farthest_box() { return {Vec3(-kFarthest), Vec3(kFarthest)}; }

bool is_empty(const Box3& box) { return box.min.x > box.max.x || box.min.y > box.max.y || box.min.z > box.max.z; }

/// The part that two boxes have in common; below zero long where they are apart.
Box3 common(const Box3& a, const Box3& b) {
  Box3 both;
  for (int axis = 0; axis < 3; ++axis) {
    both.min[axis] = std::max(a.min[axis], b.min[axis]);
    both.max[axis] = std::min(a.max[axis], b.max[axis]);
  }
  return both;
}

/// As of eight corners, so what was turned inside out is no more.
Extent moved(const Extent& extent, const Transform& transform) {
  if (transform.is_identity()) return extent;
  Box3 box;
  box.extendBy(extent.box().min);
  box.extendBy(extent.box().max);
  return Extent(transform.box(box));
}

/// The half space below a plane, if the plane lies along two axes.
Box3 box_of_half_space(const Plane& plane) {
  constexpr double kAlmostOne = 1.0 - 1e-10;
  Box3 box = farthest_box();
  for (int axis = 0; axis < 3; ++axis) {
    const double along = plane.unit_normal()[axis];
    if (std::abs(along) > kAlmostOne) (along > 0.0 ? box.max : box.min)[axis] = -plane.offset() / along;
  }
  return box;
}

const Plane* as_plane(const Shape* shape) { return dynamic_cast<const Plane*>(shape); }

bool has_place(const Object& object) {
  return object.kind != Object::Kind::light && (object.kind != Object::Kind::shape || object.shape);
}

/// Bounds and clips give an object their own box where that is smaller.
Extent cut(const Extent& own, const Object& object, const Transform& here) {
  Extent result = own;
  for (const ObjectList* cutters : {&bounds_of(object), &clips_of(object)}) {
    if (!*cutters || (*cutters)->empty()) continue;
    Box3 box = farthest_box();
    for (const Object& cutter : **cutters) {
      if (!cutter.inverted) box = common(box, extent_of_cutter(cutter, here).box());
    }
    const Extent smaller(box);
    if (smaller.volume() < result.volume()) result = smaller;
  }
  return result;
}

/// The extent of a combination whose members lie in `box`.
Extent extent_around(const Box3& box) {
  if (is_empty(box)) return Extent(farthest_box());
  const Extent whole(box);
  return std::ranges::max(whole.length) > kLongest ? Extent(farthest_box()) : whole;
}

/// The extent of a combination where it stands, from what its members make in its own space.
Extent moved_on(const Extent& members, const Object& object) {
  if (!object.cramped) return moved(members, object.placement);
  Extent result = members;
  Transform here;
  for (const std::optional<Transform>& step : object.extras->box_steps) {
    result = step ? moved(result, *step) : cut(result, object, here);
    if (step) here = here.then(*step);
  }
  return result;
}

Box3 box_of_intersection(const std::vector<Object>& members) {
  Box3 box = farthest_box();
  for (const Object& member : members) {
    if (as_plane(member.shape.get()) != nullptr) {
      box = common(box, box_of_half_space(*as_plane(placed_shape(member, member.placement, member.inverted).get())));
    } else if (!member.inverted && (!member.shape || !is_height_field(*member.shape))) {
      box = common(box, extent(member).box());
    }
  }
  return box;
}

/// Unions in it, which nest deeper than recursion may go, are summed up on the way.
Box3 box_of_union(const Object& object) {
  struct Level {
    const Object* whole;
    std::size_t next;
    Box3 box;
  };
  std::vector<Level> levels{{&object, 0, Box3()}};
  for (;;) {
    Level& level = levels.back();
    const std::vector<Object>& members = *level.whole->children;
    if (level.next < members.size()) {
      const Object& member = members[level.next++];
      if (is_plain_union(member) && member.children) {
        levels.push_back({&member, 0, Box3()});
      } else {
        level.box.extendBy(extent(member).box());
      }
      continue;
    }
    const Level done = level;
    levels.pop_back();
    if (levels.empty()) return done.box;
    levels.back().box.extendBy(moved_on(extent_around(done.box), *done.whole).box());
  }
}

/// A combination's, in its own space. `inverse` does not change it.
Extent extent_of_members(const Object& object) {
  if (!object.children) return Extent(farthest_box());
  return extent_around(object.kind == Object::Kind::intersection ? box_of_intersection(*object.children)
                                                                 : box_of_union(object));
}

}  // namespace

Extent::Extent(const Box3& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = std::max(box.min[static_cast<int>(axis)], -kFarthest);
    const double high = std::min(box.max[static_cast<int>(axis)], kFarthest);
    corner[axis] = static_cast<float>(low);
    length[axis] = static_cast<float>(high - low);
  }
}

Box3 Extent::box() const {
  Box3 result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.min[static_cast<int>(axis)] = corner[axis];
    result.max[static_cast<int>(axis)] = high(axis);
  }
  return result;
}

Box3 Extent::reach() const {
  Box3 result = box();
  for (int axis = 0; axis < 3; ++axis) {
    if (result.min[axis] <= -kAlmostFarthest) result.min[axis] = -kBoundless;
    if (result.max[axis] >= kAlmostFarthest) result.max[axis] = kBoundless;
  }
  return result;
}

bool Extent::holds(const Vec3& point) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<float>(point[static_cast<int>(axis)]);
    if (!(at >= corner[axis] && at <= high(axis))) return false;
  }
  return true;
}

bool Extent::meets(const Box3& points) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto along = static_cast<int>(axis);
    if (!(static_cast<float>(points.max[along]) >= corner[axis] &&
          static_cast<float>(points.min[along]) <= high(axis))) {
      return false;
    }
  }
  return true;
}

bool Extent::is_unbounded() const { return !(volume() <= kUnboundedVolume); }

Extent extent(const Shape& shape) {
  return Extent(as_plane(&shape) != nullptr ? farthest_box() : shape.given_bounds());
}

Extent extent_of_cutter(const Object& object, const Transform& placement) {
  if (!has_place(object)) return Extent(farthest_box());
  const Transform here = object.placement.then(placement);
  const Extent own = object.kind == Object::Kind::shape ? extent(*placed_shape(object, here, false))
                                                        : moved(extent_of_members(object), here);
  return cut(own, object, here);
}

Extent extent(const Object& object, const Transform& placement) {
  return extent(object, placement.is_identity() ? std::span<const Transform>() : std::span(&placement, 1));
}

Extent extent(const Object& object, std::span<const Transform> moves) {
  if (!has_place(object)) return Extent(farthest_box());
  if (object.kind == Object::Kind::shape) {
    Transform here = object.placement;
    for (const Transform& move : moves) here = here.then(move);
    const Extent own = extent(*placed_shape(object, here, false));
    return moves.empty() ? cut(own, object, here) : own;
  }
  Extent result = moved_on(extent_of_members(object), object);
  for (const Transform& move : moves) result = moved(result, move);
  return result;
}

}  // namespace firstlight::render
