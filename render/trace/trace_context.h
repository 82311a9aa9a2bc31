#pragma once

namespace firstlight::render {

class Accel;
struct Camera;
class MediumTable;
struct Scene;

/// The data that tracing reads: the scene, its hierarchy, and the shared table of media. Those who only hand it on need
/// to include nothing else.
struct TraceContext {
  const Scene& scene;
  const Accel& accel;
  MediumTable& media;
  const Camera* other_camera = nullptr;  ///< to look at the scene by instead of its own
  bool with_alpha = false;               ///< rays also tell what shows through

  const Camera& camera() const;
};

}  // namespace firstlight::render
