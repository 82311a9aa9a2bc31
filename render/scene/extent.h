#pragma once

#include "render/math/transform.h"
#include "render/math/vec.h"

#include <array>
#include <cstddef>
#include <span>

namespace firstlight::render {

struct Object;
class Shape;

/// A bounding box as POV-Ray 3.7 keeps it: the lower corner and the lengths of the sides, in single precision. Which
/// of two objects in one place it meets first hangs on these numbers, and scenes may ask for them.
struct Extent {
  std::array<float, 3> corner;
  std::array<float, 3> length;

  explicit Extent(const Box3& box);

  float high(std::size_t axis) const { return corner[axis] + length[axis]; }
  Box3 box() const;
  /// Where rays meet it: as box(), without end where that has its coordinates at 1e10.
  Box3 reach() const;
  bool holds(const Vec3& point) const;
  /// Whether it holds any point of the box, which is not empty.
  bool meets(const Box3& points) const;
  float volume() const { return length[0] * length[1] * length[2]; }
  /// Whether it is kept out of the bounding hierarchy, as planes are.
  bool is_unbounded() const;
};

/// Where an object lies, which may be less than its box; what has no bounds has its coordinates at 1e10. `placement`
/// is what the object's parents add to its own.
Extent extent(const Object& object, const Transform& placement = Transform());
/// The same of an object whose parents were moved step by step. It shows where the box is smaller than the object (see
/// Object::cramped): the box of a combination grows with each turn, and that of a shape is found anew, without what
/// bounds and clips it.
Extent extent(const Object& object, std::span<const Transform> moves);
/// A shape's, where it stands.
Extent extent(const Shape& shape);
/// That of an object that bounds or clips another, which stands at `placement`.
Extent extent_of_cutter(const Object& object, const Transform& placement);

}  // namespace firstlight::render
