#pragma once

#include "render/image/raster.h"
#include "render/image/transfer_curve.h"
#include "render/math/color.h"

#include <cstddef>
#include <vector>

namespace firstlight::render {

/// How a file's colours and its alpha are to be read, beside its numbers.
struct ImageKind {
  bool is_premultiplied = false;      ///< the file's colours are multiplied by alpha
  bool blends_premultiplied = false;  ///< neighbours are blended as colours that are
  /// The colours of grey files with 8 bits are kept in 8 bits when they have become those of the scene. [POV-Ray 3.7, of PNG]
  bool quantizes_grey = false;
};

/// A picture with its colours as numbers of a scene.
///
/// Memory   What the file's numbers take, and a table of what each stands for.
/// Threads  Immutable.
class Image {
 public:
  Image(Raster raster, const Transcoding& to_scene, const ImageKind& kind);

  int width() const { return raster_.width; }
  int height() const { return raster_.height; }
  /// Whether it has a palette; then its pixels have numbers.
  bool is_indexed() const { return !palette_.empty(); }
  const std::vector<FilteredColor>& palette() const { return palette_; }
  bool has_alpha() const { return has_alpha_; }
  bool is_opaque() const { return opaque_; }
  const ImageKind& kind() const { return kind_; }
  /// All numbers that its colours have. Where colours have to be divided by alpha they may have any: then `high` is not
  /// finite.
  float low() const { return low_; }
  float high() const { return high_; }

  // Pre: 0 <= x < width(), 0 <= y < height().
  /// Its number in the palette. Pre: is_indexed().
  int index(int x, int y) const;
  /// The colour as the file has it, alpha as transmit. Pre: not is_indexed().
  FilteredColor color(int x, int y) const;

 private:
  float number(std::size_t sample) const;

  Raster raster_;
  ImageKind kind_;
  std::vector<float> of_sample_;  ///< numbers of the scene, by a sample that is no float
  std::vector<FilteredColor> palette_;
  bool has_alpha_ = false;
  bool opaque_ = true;
  float low_ = 0.0f;
  float high_ = 1.0f;
};

}  // namespace firstlight::render
