#pragma once

#include "render/math/transform.h"
#include "render/scene/object.h"
#include "render/scene/solid.h"

#include <memory>
#include <optional>
#include <vector>

namespace firstlight::render {

/// The combination that an object is, after its own and its parents' inversions: the complement of a union is the
/// intersection of the complements, and the other way round (as a merge, for it has no surfaces inside).
Solid::Kind solid_kind(Object::Kind kind, bool inverted);

/// The lists that cut an object and that bound it: `clipped_by { bounded_by }` and the like make them the same.
const ObjectList& clips_of(const Object& object);
const ObjectList& bounds_of(const Object& object);

/// The shape of an object that is one, where it stands.
ShapePtr placed_shape(const Object& object, const Transform& to_world, bool inverted);

/// The geometry of an object without its surfaces: where it is, not how it looks. Nothing for lights.
std::optional<Solid> region(const Object& object, const Transform& to_world, bool inverted);
std::vector<Solid> regions(const ObjectList& objects, const Transform& to_world);
/// The bounds of an object: rays that miss the box of such a region miss it.
std::vector<Solid> bounding_regions(const ObjectList& objects, const Transform& to_world);

}  // namespace firstlight::render
