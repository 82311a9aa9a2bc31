#pragma once

#include "render/math/vec.h"

#include <vector>

namespace firstlight::render {

struct Scene;

/// Where the things are that light may pass through: most ways to lights lead past all of them, and are not to be looked
/// at surface by surface.
///
/// Threads  Immutable.
class SeeThrough {
 public:
  explicit SeeThrough(const Scene& scene);

  /// False only where nothing lies on the ray that casts a shadow and that light may pass through.
  bool may_lie_on(const Ray& ray) const;

 private:
  std::vector<Box3> boxes_;
};

}  // namespace firstlight::render
