#pragma once

#include "render/math/color.h"

#include <span>
#include <vector>

namespace firstlight::render {

/// How different two pictures look to somebody who flips between them on a screen: 0 for equal pixels, at most 1.
///
/// Units    Colours are linear light, clipped to [0, 1] (the published measure begins with sRGB values, and makes them
///          linear first).
/// Source   Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for
///          Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020; the low dynamic range measure.
/// Cost     The reference picture is prepared once; a comparison takes some 0.2 us a pixel on one processor.
/// Threads  Compares with all processors; may be called from any thread.
class Flip {
 public:
  /// The paper's: a screen of 0.7 m and 3840 pixels seen from 0.7 m.
  static constexpr double kPixelsPerDegree = 67.0;

  Flip(std::span<const Rgb> reference, int width, int height, double pixels_per_degree = kPixelsPerDegree);

  /// The error of each pixel, rows from the top. Pre: as many pixels as the reference.
  std::vector<float> map(std::span<const Rgb> test) const;
  /// Their mean.
  double mean(std::span<const Rgb> test) const;

 private:
  using Plane = std::vector<float>;

  /// A picture as it is compared: filtered colours in L*a*b* after the Hunt adjustment, and how strong edges and points
  /// are.
  struct Seen {
    Plane lightness, a, b, edges, points;
  };

  /// A filter as the sum of products of one-dimensional filters: taps at -radius .. radius.
  using Taps = std::vector<float>;
  struct Filters {
    Taps achromatic, red_green;         ///< contrast sensitivity, one Gaussian each
    Taps blue_yellow_1, blue_yellow_2;  ///< the two Gaussians, each with the root of its share
    Taps smooth, edge, point;           ///< Gaussian, its first and its second derivative
  };
  static Filters make_filters(double pixels_per_degree);

  Seen see(std::span<const Rgb> picture) const;
  Plane filter(const Plane& plane, const Taps& along_x, const Taps& along_y) const;

  int width_;
  int height_;
  Filters filters_;
  Seen reference_;
};

}  // namespace firstlight::render
