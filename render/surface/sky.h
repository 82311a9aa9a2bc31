#pragma once

#include "render/math/columns.h"
#include "render/scene/scene.h"
#include "render/surface/compiled_pigment.h"

#include <cstddef>
#include <deque>
#include <memory>
#include <span>

namespace firstlight::render {

/// The light of rays that meet nothing: the pigments of the sky sphere, and the background behind them.
///
/// Source   POV-Ray 3.7 manual, "Sky Sphere" and "Background". The pigments are the layers of a texture that shines,
///          the last one topmost; before language version 3.7 the tints of all layers were multiplied with each other,
///          and so were their filters.
/// Threads  Immutable.
class Sky {
 public:
  /// Pre: `scene` outlives this, unchanged.
  Sky(const Scene& scene, const PatternWorld& world);

  /// Whether it is the background everywhere.
  bool is_even() const { return pigments_.empty(); }
  const Rgb& background() const { return background_; }
  /// The same for a picture with an alpha channel.
  const FilteredColor& background_with_alpha() const { return background_with_alpha_; }
  /// colors[i] in the i-th of `count` directions, of unit length, in the scene, in front of `background`.
  void colors(const Columns3<double>& directions, std::size_t count, const Rgb& background,
              Columns3<float>& colors) const;
  /// The same in front of the background of a picture with an alpha channel, and what shows through both. Before
  /// language version 3.7 that was all, and the sky was seen in mirrors only.
  void colors_with_alpha(const Columns3<double>& directions, std::size_t count, Columns3<float>& colors,
                         Column<float>& clear) const;

 private:
  /// Light that the layers let through which are in front of something.
  struct Above;
  /// Sets `colors` to the light of the pigments alone.
  void lay(const Columns3<double>& directions, std::size_t count, Columns3<float>& colors,
           std::span<Above> above) const;
  static Rgb layer_light(const FilteredColor& color, const Above& above);
  static Rgb old_layer_light(const FilteredColor& color, Above& above);

  Rgb background_;
  FilteredColor background_with_alpha_;
  std::shared_ptr<const SkySphere> sphere_;  ///< null: none
  std::deque<CompiledPigment> pigments_;     ///< topmost first
  bool old_filters_ = false;
};

}  // namespace firstlight::render
