#pragma once

#include "render/math/vec.h"
#include "render/scene/object.h"
#include "render/scene/solid.h"

#include <optional>

namespace firstlight::render {

/// The geometry of one object, for a front end's questions about where it is while a scene is read. Answers are those
/// that rendering gives.
/// Cost     Making one costs the object's size; keep it for further questions.
class ObjectProbe {
 public:
  struct Hit {
    Vec3 point;
    Vec3 normal;
  };

  explicit ObjectProbe(const Object& object);
  /// False when a part of the object is described and not made; then the answers are not to be relied on.
  bool is_complete() const { return complete_; }
  /// The first point on the way from `origin`; `direction` may have any length.
  std::optional<Hit> trace(const Vec3& origin, const Vec3& direction) const;
  bool inside(const Vec3& point) const;

 private:
  std::shared_ptr<const Solid> solid_;  ///< null: the object has no geometry
  bool complete_;
};

/// Whether the object is made of shapes that are there, throughout.
bool is_made(const Object& object);

}  // namespace firstlight::render
