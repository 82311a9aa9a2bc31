#pragma once

#include "render/accel/accel.h"
#include "render/scene/scene.h"
#include "render/trace/medium_table.h"

namespace firstlight::render {

/// What tracing reads: the scene, its hierarchy, and the shared table of media.
struct TraceContext {
  const Scene& scene;
  const Accel& accel;
  MediumTable& media;
  const Camera* other_camera = nullptr;  ///< to look at the scene by instead of its own

  const Camera& camera() const { return other_camera != nullptr ? *other_camera : scene.camera; }
};

}  // namespace firstlight::render
