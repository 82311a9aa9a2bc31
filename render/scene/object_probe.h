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
  /// The first point on the way from `origin`; `direction` may have any length.
  std::optional<Hit> trace(const Vec3& origin, const Vec3& direction) const;
  bool inside(const Vec3& point) const;

 private:
  std::shared_ptr<const Solid> solid_;  ///< null: the object has no geometry
};

}  // namespace firstlight::render
