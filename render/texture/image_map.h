#pragma once

#include "render/image/image.h"
#include "render/texture/image_use.h"

#include <memory>
#include <optional>
#include <vector>

namespace firstlight::render {

/// A picture laid over space, ready to be asked.
///
/// Source   POV-Ray 3.7 manual, "Image Map"; places, weights of neighbours and their rounding are POV-Ray 3.7's.
/// Threads  Immutable.
class ImageMap {
 public:
  /// In pixels, from the left and from the top. Pixel (i, j) is at i <= x < i+1, j <= y < j+1.
  struct Place {
    double x = 0.0;
    double y = 0.0;
  };
  struct Sample {
    FilteredColor color;
    int index = -1;  ///< number in the palette; -1: there is no palette
  };

  /// Without an image that has been loaded nothing is anywhere.
  explicit ImageMap(std::shared_ptr<const ImageUse> use);

  const ImageUse& use() const { return *use_; }
  int width() const { return width_; }
  int height() const { return height_; }
  bool has_alpha() const { return has_alpha_; }
  /// Whether light passes some of its pixels, or there is room beside it.
  bool lets_light_through() const;

  /// Where in the picture a point is; nothing where the picture is not.
  std::optional<Place> place(const Vec3& point) const;
  /// The picture there, its colours not multiplied by alpha.
  Sample at(const Place& place) const { return sample(place, false); }
  /// The same, multiplied by alpha where the file has such colours.
  Sample as_stored(const Place& place) const;

 private:
  Sample sample(const Place& place, bool premultiplied) const;
  /// The pixel at whole coordinates that may lie up to two pixels beside the picture.
  Sample pixel(double x, double y, bool premultiplied) const;
  Sample blended(const Place& place, bool premultiplied) const;

  std::shared_ptr<const ImageUse> use_;
  std::shared_ptr<const Image> image_;
  std::vector<FilteredColor> palette_;  ///< with the changes of its use
  bool has_alpha_ = false;
  bool changes_opacity_ = false;
  int width_ = 0;
  int height_ = 0;
  double period_x_ = 0.0;  ///< pixels in a unit of space
  double period_y_ = 0.0;
};

/// Whether light passes a picture that is laid so, somewhere.
bool lets_light_through(const std::shared_ptr<const ImageUse>& use);

}  // namespace firstlight::render
