#pragma once

#include "render/camera/camera.h"
#include "render/scene/bounding_rules.h"
#include "render/scene/object.h"
#include "render/scene/scene.h"

#include <memory>

namespace firstlight::render {

/// Takes the description of a scene piece by piece and freezes it: dissolves unions, hands placements, textures,
/// interiors and flags down to the leaves, and numbers everything. A front end's only way to a Scene.
class SceneBuilder {
 public:
  SceneBuilder();
  ~SceneBuilder();
  SceneBuilder(SceneBuilder&&) noexcept;
  SceneBuilder& operator=(SceneBuilder&&) noexcept;

  /// A scene's last camera counts.
  void set_camera(const Camera& camera);
  bool has_camera() const;
  Settings& settings();
  const Settings& settings() const;
  Atmosphere& atmosphere();
  /// For the objects that are added from now on.
  void set_bounding(const BoundingRules& rules);
  /// A top-level object, in the order of the scene text; lights are objects too. `default_texture` covers what has
  /// none.
  void add(const Object& object, const TexturePtr& default_texture);
  /// Top-level solids so far: dissolved unions count as their members, lights not at all.
  std::size_t object_count() const;
  /// The frozen scene; the builder is empty afterwards.
  std::unique_ptr<const Scene> build();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace firstlight::render
