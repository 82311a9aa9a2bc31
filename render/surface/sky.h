#pragma once

#include "render/math/columns.h"
#include "render/scene/scene.h"
#include "render/surface/compiled_pigment.h"

#include <cstddef>
#include <deque>
#include <memory>

namespace firstlight::render {

/// The light of rays that meet nothing: the pigments of the sky sphere, and the background behind them.
///
/// Source   POV-Ray 3.7 manual, "Sky Sphere" and "Background". The pigments are the layers of a texture that shines, the
///          last one topmost; before language version 3.7 the tints of all layers were multiplied with each other, and so
///          were their filters.
/// Threads  Immutable.
class Sky {
 public:
  /// Pre: `scene` outlives this, unchanged.
  Sky(const Scene& scene, const PatternWorld& world);

  /// Whether it is the background everywhere.
  bool is_even() const { return pigments_.empty(); }
  const Rgb& background() const { return background_; }
  /// colors[i] in the i-th of `count` directions, of unit length, in the scene.
  void colors(const Columns3<double>& directions, std::size_t count, Columns3<float>& colors) const;

 private:
  Rgb background_;
  std::shared_ptr<const SkySphere> sphere_;  ///< null: none
  std::deque<CompiledPigment> pigments_;     ///< topmost first
  bool old_filters_ = false;
};

}  // namespace firstlight::render
