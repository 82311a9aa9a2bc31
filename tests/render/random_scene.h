#pragma once

#include "render/accel/accel.h"
#include "render/scene/scene.h"
#include "render/trace/medium_table.h"
#include "render/trace/step.h"

#include <cstdint>
#include <memory>

namespace firstlight::render {

/// Kinds of textures and lights of a random scene.
enum class Fancy {
  plausible,   ///< what makers of scenes write, with everything that surfaces can do
  clear_rows,  ///< the same, and nothing bends: glass that takes no light away, with highlights, in rows
  wild,        ///< negative colours, filters and powers as well, and what makes more light of little
};

/// A small scene made of everything at random: shapes that overlap, layers, maps, mirrors, matter, lights.
class RandomScene {
 public:
  RandomScene(std::uint32_t seed, Fancy fancy);

  const Scene& scene() const { return *scene_; }
  TraceContext context() { return {*scene_, *accel_, *media_}; }

  /// A primary ray through a point of the picture, whose corners are (0, 0) and (1, 1).
  RayTask primary(double x, double y, std::uint32_t sample);

 private:
  std::unique_ptr<const Scene> scene_;
  std::unique_ptr<Accel> accel_;
  std::unique_ptr<MediumTable> media_ = std::make_unique<MediumTable>();
};

}  // namespace firstlight::render
