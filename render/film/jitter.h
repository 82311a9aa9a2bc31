#pragma once

#include "render/film/antialias_settings.h"
#include "render/math/place_jitter.h"

namespace firstlight::render {

/// A place in the picture, or a way from one: pixels, the middle of the first being (0, 0).
struct PicturePoint {
  double x = 0.0;
  double y = 0.0;
};

/// Moves samples a little from their places, always in the same way.
/// Source   POV-Ray 3.7: the same moves for the same places.
class Jitter {
 public:
  /// `cells`: as many parts as the side of a pixel is cut into.
  Jitter(const AntialiasSettings& settings, int cells)
      : scale_(settings.jitter ? static_cast<double>(static_cast<float>(settings.jitter_amount)) / cells : 0.0) {}

  PicturePoint move(const PicturePoint& place) const {
    if (scale_ <= 0.0) return place;
    const PlaceJitter jitter = place_jitter(place.x, place.y);
    return {place.x + jitter.x * scale_, place.y + jitter.y * scale_};
  }

 private:
  double scale_;
};

}  // namespace firstlight::render
