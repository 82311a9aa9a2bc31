#pragma once

#include "render/light/light.h"
#include "render/math/vec.h"
#include "render/scene/object_group.h"

#include <span>
#include <string>
#include <vector>

namespace firstlight::render {

struct Camera;
struct Scene;

/// Facts that the order of rays may go by: what a scene's lights and objects are called, where light comes from, where
/// the scene is seen from. It is for those who need not know shapes and textures.
///
/// Memory   Views of the scene, which has to outlive them.
struct SceneIndex {
  std::span<const Light> lights;
  std::span<const std::vector<std::string>> light_names;  ///< SDL identifiers of each light, the outermost first
  std::span<const ObjectGroup> objects;                   ///< RayTask::object is an index into them
  int max_trace_level = 0;
  Vec3 eye{0.0};  ///< more or less: the rays of some cameras begin at many places
};

/// `other_camera`: that the scene is seen by instead of its own; may be null.
SceneIndex index_of(const Scene& scene, const Camera* other_camera = nullptr);

}  // namespace firstlight::render
