#pragma once

#include "render/accel/accel.h"
#include "render/film/film.h"
#include "render/scene/scene.h"
#include "render/trace/medium_table.h"
#include "render/trace/trace_context.h"

#include <memory>

namespace firstlight::priority {

/// The paper's scene: a sphere-flake in a room of mirrors, three lights; with glass on some of the spheres, so that all
/// kinds of rays occur.
class MirrorRoom {
 public:
  /// `depth`: generations of the flake, each sphere bearing nine smaller ones. `glass`: every how manieth sphere; 0:
  /// none. `lights`: at most 4.
  explicit MirrorRoom(int depth, int glass = 3, int max_trace_level = 5, int lights = 3);

  const render::Scene& scene() const { return *scene_; }
  const render::Accel& accel() const { return *accel_; }
  /// With a table of media of its own.
  render::TraceContext context();

 private:
  std::unique_ptr<const render::Scene> scene_;
  std::unique_ptr<render::Accel> accel_;
  std::unique_ptr<render::MediumTable> media_;
};

}  // namespace firstlight::priority
