#include "render/scene/scene_index.h"

#include "render/scene/scene.h"

namespace firstlight::render {

SceneIndex index_of(const Scene& scene, const Camera* other_camera) {
  const Camera& camera = other_camera != nullptr ? *other_camera : scene.camera;
  return {scene.lights, scene.light_names, scene.objects, scene.settings.max_trace_level, camera.location};
}

}  // namespace firstlight::render
